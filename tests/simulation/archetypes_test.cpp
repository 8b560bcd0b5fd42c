// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/particle/bond_common_edges.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/archetypes.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;

namespace {

// Hoek-Brown's two functions without its friction angle, as the archetype has it.
struct TwoFunctions {
  double major_stress_at_failure(double minor) const {
    return HoekBrown{}.major_stress_at_failure(minor);
  }
  double tensile_strength() const { return HoekBrown{}.tensile_strength(); }
};

// The shipped models that the archetypes stand in for; the rest are defaults.
const auto shipped = Model{}
                         .narrow_phase(OverlapChord{})
                         .contact_law(LinearSpringCoulomb{})
                         .integrator(VelocityVerlet{})
                         .boundary(NoBoundary{})
                         .criterion(TwoFunctions{});

// A square 1 mm deep in a platen on either side breaks at the first check; then its pieces fly.
struct Outcome {
  std::size_t breaks = 0;
  std::vector<Vec2> positions;
  std::vector<double> ratios;
  double stored = 0;
  bool operator==(const Outcome&) const = default;
};

template <class ModelType>
Outcome crushed(const ModelType& model) {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon platen{{-0.02, 0}, {0.04, 0}, {0.04, 0.016}, {-0.02, 0.016}};
  const Assembly pressed{.particles = {{square},
                                       {platen.moved({}, {0, 0.0150}), Motion::prescribed},
                                       {platen.moved({}, {0, -0.0150}), Motion::prescribed}}};
  Simulation sim{model, pressed, Rock{}};
  for (int i = 0; i < 20; ++i) sim.step();
  Outcome outcome{.breaks = sim.breaks().size(), .positions = {}, .ratios = sim.failed_ratios()};
  for (const Body& body : sim.particles().bodies()) outcome.positions.push_back(body.position);
  sim.contacts().for_each_touching([&](const auto& contact) {
    outcome.stored +=
        sim.model().contact_model.law.stored_energy(contact.geometry, contact.history);
  });
  return outcome;
}

}  // namespace

TEST_CASE("a whole simulation of archetypes breaks a square as the models behind them do") {
  const auto archetypes = Model{}
                              .execution(archetype::Execution{0})
                              .broad_phase(archetype::BroadPhase{0})
                              .narrow_phase(archetype::NarrowPhase{0})
                              .contact_law(archetype::ContactLaw{0})
                              .integrator(archetype::Integrator{0})
                              .damping(archetype::Damping{0})
                              .body_force(archetype::BodyForce{0})
                              .time_step(archetype::TimeStep{0})
                              .boundary(archetype::Boundary{0})
                              .mesher(archetype::Mesher{0})
                              .element(archetype::Element{0})
                              .plane_state(archetype::PlaneState{0})
                              .support(archetype::Support{0})
                              .criterion(archetype::Criterion{0})
                              .trigger(archetype::Trigger{0})
                              .line_fit(archetype::LineFit{0})
                              .splitter(archetype::Splitter{0})
                              .inheritance(archetype::Inheritance{0});
  const Outcome expected = crushed(shipped);
  REQUIRE(expected.breaks >= 1);
  CHECK(expected.stored > 0);
  CHECK(crushed(archetypes) == expected);
}

TEST_CASE("an archetype works with shipped models in all other roles") {
  const Outcome expected = crushed(shipped);
  CHECK(crushed(shipped.execution(archetype::Execution{0})) == expected);
  CHECK(crushed(shipped.broad_phase(archetype::BroadPhase{0})) == expected);
  CHECK(crushed(shipped.narrow_phase(archetype::NarrowPhase{0})) == expected);
  CHECK(crushed(shipped.contact_law(archetype::ContactLaw{0})) == expected);
  CHECK(crushed(shipped.integrator(archetype::Integrator{0})) == expected);
  CHECK(crushed(shipped.damping(archetype::Damping{0})) == expected);
  CHECK(crushed(shipped.time_step(archetype::TimeStep{0})) == expected);
  CHECK(crushed(shipped.boundary(archetype::Boundary{0})) == expected);
  CHECK(crushed(shipped.mesher(archetype::Mesher{0})) == expected);
  CHECK(crushed(shipped.element(archetype::Element{0})) == expected);
  CHECK(crushed(shipped.plane_state(archetype::PlaneState{0})) == expected);
  CHECK(crushed(shipped.support(archetype::Support{0})) == expected);
  CHECK(crushed(shipped.criterion(archetype::Criterion{0})) == expected);
  CHECK(crushed(shipped.trigger(archetype::Trigger{0})) == expected);
  CHECK(crushed(shipped.line_fit(archetype::LineFit{0})) == expected);
  CHECK(crushed(shipped.splitter(archetype::Splitter{0})) == expected);
  CHECK(crushed(shipped.inheritance(archetype::Inheritance{0})) == expected);
}

TEST_CASE("a simulation with an archetype of a bond law is that of the law behind it") {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  Assembly row{.particles = {}};
  for (int i = 0; i < 4; ++i)
    row.particles.push_back(
        {square.moved({}, {0.016 * i, 0}), Motion::free, {2.0 * i, 0.5 * (i % 2)}});
  bond_common_edges(row);
  const auto run = [&](const auto& law) {
    Simulation sim{shipped.bond_law(law), row, Rock{}};
    for (int i = 0; i < 200; ++i) sim.step();
    CHECK(!sim.bond_breaks().empty());
    std::vector<double> numbers{sim.bonds().loss(), sim.bonds().stored_energy(0.016)};
    for (const Body& body : sim.particles().bodies()) numbers.push_back(body.position.x());
    return numbers;
  };
  CHECK(run(archetype::BondLaw{0}) == run(BrittleBond{}));
}
