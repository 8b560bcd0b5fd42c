// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/needs_elements.hpp>

#include <doctest/doctest.h>

#include <type_traits>

#include <riprap/conformance/acceleration.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/breakage_passes.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

// Declared alone: a program that makes a mesh with it does not link.
struct MesherWithoutDefinition {
  Mesh operator()(Ring) const;
};

struct CountingMesher : UniformMesher {
  int* made = nullptr;
  Mesh operator()(Ring ring) const {
    ++*made;
    return UniformMesher::operator()(ring);
  }
};

// Fails in shear where the major mean stress reaches a limit.
struct LargestMeanStress {
  double limit = 100e6;
  FailureMode operator()(const LoadedParticle& particle) const {
    const double major = particle.mean_stress().principal_values().major;
    return major >= limit ? FailureMode::shear : FailureMode::intact;
  }
};
struct TearsAlways {
  FailureMode operator()(const LoadedParticle&) const { return FailureMode::tension; }
};
// Along the major mean stress through the centroid.
struct AlongMajorStress {
  std::optional<Line> operator()(const LoadedParticle& particle) const {
    return Line{particle.centroid(), particle.mean_stress().principal().major_direction};
  }
};
// By both.
struct FailedUnderTwoLoads {
  bool operator()(const FailureCount& failures, const LoadedParticle& particle) const {
    return failures.failed > 0 && particle.loads().size() == 2;
  }
};
struct PointsAlongMajorStress {
  std::optional<Line> operator()(std::span<const WeightedPoint> points, const FailurePlanes&,
                                 const Stress2&, const LoadedParticle& particle) const {
    const std::optional<Line> along = AlongMajorStress{}(particle);
    return Line{weighted_moments(points).mean, along->direction};
  }
};
// With twice the strength; keeps the largest force that it is shown.
struct TwiceAsStrong : LargestMeanStress {
  double* force = nullptr;
  double strength_factor(ParticleId, double) const { return 2; }
  FailureMode operator()(const LoadedParticle& particle) const {
    for (const ContactLoad& load : particle.loads())
      *force = std::max(*force, load.force_lab.norm());
    return LargestMeanStress::operator()(particle);
  }
};

const auto by_loads = Model{}.trigger(LargestMeanStress{}).line_fit(AlongMajorStress{});

template <class ModelType>
constexpr bool needs(const ModelType&) {
  return needs_elements<decltype(ModelType::breakage_model)>;
}

}  // namespace

TEST_CASE("elements are needed unless trigger and line fit both do without") {
  CHECK(needs(Model{}));
  CHECK(needs(Model{}.trigger(LargestMeanStress{})));
  CHECK(needs(Model{}.line_fit(AlongMajorStress{})));
  CHECK(needs(Model{}.trigger(FailedUnderTwoLoads{}).line_fit(AlongMajorStress{})));
  CHECK(needs(Model{}.trigger(LargestMeanStress{}).line_fit(PointsAlongMajorStress{})));
  CHECK_FALSE(needs(by_loads));
}

TEST_CASE("without them particles break, and no mesh is made: there is no code for it") {
  const auto model = by_loads.trigger(LargestMeanStress{20e6}).boundary(NoBoundary{});
  Simulation sim{model.mesher(MesherWithoutDefinition{}), internal::closing_platens(), Rock{}};
  static_assert(!decltype(sim)::needs_elements);
  for (int step = 0; step < 1200; ++step) sim.step();
  REQUIRE(sim.breaks().size() > 5);
  CHECK(sim.operator_bytes() == 0);
  for (const BreakEvent& event : sim.breaks()) {
    CHECK(event.mode == FailureMode::shear);
    CHECK(event.failures.elements == 0);
    CHECK(event.failures.ratio() == 0);
    CHECK(event.crack_length > 0);
  }
  for (const double ratio : sim.failed_ratios()) CHECK(ratio == 0);
}

TEST_CASE("a mesh is made of those particles alone that break, for a line through elements") {
  int made = 0;
  const auto count = [&](const auto& model) {
    made = 0;
    const auto counting = model.mesher(CountingMesher{{}, &made});
    const Simulation sim{counting, crushed, Rock{}};
    return Pass(counting).find(sim).size();
  };
  CHECK(count(by_loads) == 2);
  CHECK(made == 0);
  CHECK(count(by_loads.line_fit(WeightedXY{})) == 2);
  CHECK(made == 2);
  CHECK(count(by_loads.trigger(LargestMeanStress{1e12}).line_fit(WeightedXY{})) == 0);
  CHECK(made == 0);
}

TEST_CASE("mode, failures and line come from what decides: loads, elements, or both") {
  const auto first = [](const auto& model) {
    const Simulation sim{model, crushed, Rock{}};
    Pass pass(model);
    const BreakagePass::Cracks& cracks = pass.find(sim);
    REQUIRE(cracks.size() == 2);
    return cracks[0].second;
  };
  const Crack by_elements = first(Model{});
  const FailureMode mode = by_elements.mode;
  REQUIRE(by_elements.failures.failed > 0);

  const Crack trigger_alone = first(Model{}.trigger(LargestMeanStress{}));
  CHECK(trigger_alone.mode == FailureMode::shear);
  CHECK(trigger_alone.failures.failed == by_elements.failures.failed);
  CHECK(trigger_alone.line.point == by_elements.line.point);
  CHECK(first(Model{}.trigger(TearsAlways{})).mode == FailureMode::tension);

  const Crack line_alone = first(Model{}.line_fit(AlongMajorStress{}));
  CHECK(line_alone.mode == mode);
  CHECK(line_alone.failures.failed == by_elements.failures.failed);
  // Pressed along axis 2, in the middle.
  CHECK(std::abs(line_alone.line.direction.x()) < 0.1);
  CHECK(polygon_area(line_alone.pieces.left) == near_relative(0.5 * 0.016 * 0.016, 0.1));

  const Crack both =
      first(Model{}.trigger(FailedUnderTwoLoads{}).line_fit(PointsAlongMajorStress{}));
  CHECK(both.mode == mode);
  CHECK(both.failures.failed == by_elements.failures.failed);
  CHECK(both.line.direction == line_alone.line.direction);
  CHECK(both.line.point != line_alone.line.point);
}

TEST_CASE("loads are shown over the strength factor of the particle") {
  double force = 0;
  const auto strong = by_loads.trigger(TwiceAsStrong{{}, &force});
  const Simulation sim{strong, crushed, Rock{}};
  Pass pass(strong);
  double largest = 0;
  for (const BodyIndex i : {0u, 3u})
    for (const ContactLoad& load : loads_on(sim.contacts(), i))
      largest = std::max(largest, load.force_lab.norm());
  const double stress = largest / (0.016 * 0.016);
  REQUIRE(stress > 100e6);
  CHECK(pass.find(sim).size() == (stress > 200e6 ? 2 : 0));
  CHECK(force == near_relative(0.5 * largest, 1e-15));
}

TEST_CASE("a refused cut is not tried again under the same partners") {
  int asked = 0;
  struct Counting : AlongMajorStress {
    int* asked;
    std::optional<Line> operator()(const LoadedParticle& particle) const {
      ++*asked;
      return AlongMajorStress::operator()(particle);
    }
  };
  const auto counting =
      by_loads.splitter(StraightCut{.minimum_area = 0.6}).line_fit(Counting{{}, &asked});
  const Simulation sim{counting, crushed, Rock{}};
  Pass pass(counting);
  CHECK(pass.find(sim).empty());
  CHECK(asked == 2);
  CHECK(pass.find(sim).empty());
  CHECK(asked == 2);
}

TEST_CASE("results are the same without acceleration") {
  CHECK(to_text(acceleration_violations(by_loads.trigger(LargestMeanStress{20e6}))) == "");
  CHECK(to_text(acceleration_violations(Model{}.trigger(LargestMeanStress{20e6}))) == "");
}
