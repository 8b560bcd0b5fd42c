// SPDX-License-Identifier: BSL-1.0
// Several rocks in one assembly.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <riprap/breakage/criterion/rankine.hpp>
#include <riprap/breakage/line_fit/loaded_diameter.hpp>
#include <riprap/breakage/trigger/brazilian_strength.hpp>
#include <riprap/breakage/trigger/with_weibull_strength.hpp>
#include <riprap/simulation/simulation.hpp>
#include <riprap/stress/operator_store/keep_all_operators.hpp>
#include <support/breakage_passes.hpp>
#include <support/crushing.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>
#include <support/same_run.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

// Squares and platens of breakage_passes.hpp; the first square is of material 1.
Assembly two_materials() {
  Assembly assembly = crushed;
  assembly.particles[0].material = 1;
  return assembly;
}

template <class ModelType>
std::vector<BodyIndex> broken(const ModelType& model, const Rocks& rocks,
                              const Assembly& assembly = two_materials()) {
  const Simulation sim{model, assembly, rocks};
  BreakageStage<ModelType> stage{model};
  std::vector<BodyIndex> out;
  for (const auto& [i, crack] : stage.find_cracks(model, sim.rocks(), sim.mean_area(),
                                                  sim.particles(), sim.contacts(), NoPhaseTimer{}))
    out.push_back(i);
  std::sort(out.begin(), out.end());
  return out;
}

const Rock weak{.strength_factor = 1e-3};
const Rock strong{.strength_factor = 1e3};

}  // namespace

TEST_CASE("a list of one rock, or of many of which one is used, runs to the same bytes") {
  const auto one = run_of(Model{}, 1500);
  CHECK(same_bytes(run_of(Model{}, 1500, Rocks{Rock{}}), one));
  const Rocks two{Rock{.young = 1e9, .density = 1, .strength_factor = 0.1}, Rock{}};
  CHECK(same_bytes(run_of(Model{}, 1500, two, {1, 1, 1, 1}), one));
  CHECK_FALSE(same_bytes(run_of(Model{}, 1500, two, {1, 0, 1, 1}), one));
}

TEST_CASE("screening, caches and batches change no byte of a run of two rocks") {
  const Rocks two{Rock{.young = 20e9, .poisson = 0.3, .density = 2200, .strength_factor = 0.5},
                  Rock{}};
  const auto plain = run_of(Model{}.without_acceleration(), 1500, two, {0, 1, 1, 0});
  CHECK(same_bytes(run_of(Model{}, 1500, two, {0, 1, 1, 0}), plain));
}

TEST_CASE("a particle has mass, rock and elasticity of its own material") {
  const Rocks rocks{Rock{.density = 2500}, Rock{.young = 5e9, .poisson = 0.4, .density = 2000}};
  const Simulation sim{Model{}, two_materials(), rocks};
  const double volume = 0.016 * 0.016 * 0.016;
  CHECK(sim.particles().body(0).mass == near_relative(2000 * volume, 1e-13));
  CHECK(sim.particles().body(3).mass == near_relative(2500 * volume, 1e-13));
  CHECK(sim.rock(0).young == 5e9);
  CHECK(sim.rock(3).density == 2500);
  CHECK(sim.rock().density == 2500);
  CHECK_THROWS_AS((void)sim.rock(4), InvalidInput);
  // Stresses depend on Poisson's ratio: those of a simulation of that rock alone, by bytes.
  const Simulation soft{Model{}, crushed, rocks[1]};
  const Simulation hard{Model{}, crushed, rocks[0]};
  const auto same = [&](const auto& a, BodyIndex i, const auto& b) {
    const ElementStress p = a.element_stress(i);
    const ElementStress q = b.element_stress(i);
    double difference = 0;
    for (std::size_t e = 0; e < p.size(); ++e)
      difference += std::abs(p[e].s11 - q[e].s11) + std::abs(p[e].s12 - q[e].s12);
    return difference == 0;
  };
  CHECK(same(sim, 0, soft));
  CHECK(same(sim, 3, hard));
  CHECK_FALSE(same(sim, 0, hard));
}

TEST_CASE("pieces are of the rock of their parent") {
  Assembly assembly = square_between_platens(0.2);
  assembly.particles[0].material = 1;
  Simulation sim{Model{}.boundary(NoBoundary{}), assembly,
                 Rocks{Rock{}, Rock{.density = 1700, .strength_factor = 0.05}}};
  for (int i = 0; i < 2000 && sim.breaks().empty(); ++i) sim.step();
  REQUIRE_FALSE(sim.breaks().empty());
  for (BodyIndex i = 0; i < sim.particles().size(); ++i) {
    const bool piece = sim.particles().ancestry(i).root == 0;
    CHECK(sim.particles().material(i) == (piece ? 1 : 0));
    CHECK(sim.particles().body(i).mass ==
          near_relative((piece ? 1700 : 2500) * 0.016 * sim.particles().shape(i).area, 1e-12));
  }
}

TEST_CASE("a material without a rock is refused, with the particle") {
  CHECK(message_of([] {
          Simulation sim{Model{}, two_materials(), Rock{}};
        }) == "particle 0: material = 1: must be below the number of rocks, 1");
  Simulation sim{Model{}.boundary(NoBoundary{}), crushed, Rocks{Rock{}, Rock{}}};
  const auto add = [&](MaterialIndex material) {
    return message_of([&] {
      (void)sim.add(rectangle({1, 1}, 0.01, 0.01), Motion::free, {0, 0}, 0, material);
    });
  };
  CHECK(add(2) == "material of the added body = 2: must be below the number of rocks");
  CHECK(sim.particles().size() == 4);
  CHECK(add(1).empty());
  CHECK(sim.particles().material(4) == 1);
}

TEST_CASE("a strength factor is the criterion's strength over that of the other rock") {
  // Rankine's criterion is proportional to its tension.
  for (const double tension : {3e6, 3e7, 3e8, 3e9, 3e10}) {
    const auto by_factor = broken(Model{}.criterion(Rankine{.tension = 1e6}),
                                  Rock{.strength_factor = tension / 1e6}, crushed);
    CHECK(by_factor == broken(Model{}.criterion(Rankine{.tension = tension}), Rock{}, crushed));
  }
}

TEST_CASE("the weak rock breaks and the strong one does not, by each kind of trigger") {
  const std::vector<BodyIndex> first{0};
  const std::vector<BodyIndex> last{3};
  const auto check = [&](const auto& model) {
    CHECK(broken(model, Rocks{strong, weak}) == first);
    CHECK(broken(model, Rocks{weak, strong}) == last);
    CHECK(broken(model.without_acceleration(), Rocks{weak, strong}) == last);
  };
  check(Model{});
  check(Model{}.trigger(WeibullStrength{}));
  check(Model{}.trigger(BrazilianStrength{1e9}).line_fit(LoadedDiameter{}));
  check(Model{}
            .trigger(WithWeibullStrength<BrazilianStrength>{.trigger = {1e9}})
            .line_fit(LoadedDiameter{}));
}
