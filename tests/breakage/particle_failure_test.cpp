// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/particle_failure.hpp>

#include <doctest/doctest.h>

#include <vector>

#include <riprap/simulation/model_parts.hpp>
#include <riprap/stress/support/two_pinned_contacts.hpp>

using namespace riprap;

namespace {

// Every particle has twice the strength of the criterion.
struct TwiceAsStrong : FailedElementRatio {
  [[nodiscard]] static double strength_factor(ParticleId, double) { return 2; }
};

const StressModel<> part;

}  // namespace

TEST_CASE("failed elements are those of the stress, under loads divided by the strength") {
  Particles particles(0.016, 2500);
  particles.add(ConvexPolygon{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}}, Motion::free);
  const auto op = build_operator(part, Rock{}, particles, 0);
  const std::vector<ContactLoad> loads{{{0, 0.008}, {0, -2e5}, 2e5}, {{0, -0.008}, {0, 2e5}, 2e5}};

  StressEvaluation evaluate;
  const BreakageModel<> weak{};
  const auto [stress, failures] =
      evaluate_particle(weak, part.support, *op, Rock{}, particles, 0, loads, evaluate);
  CHECK(failures.elements == op->mesh().size());
  CHECK(failures.failed == count_failures(weak.criterion, stress).failed);
  CHECK(failures.failed > 0);

  StressEvaluation evaluate_strong;
  const BreakageModel<HoekBrown, TwiceAsStrong> strong{};
  const ParticleFailure half =
      evaluate_particle(strong, part.support, *op, Rock{}, particles, 0, loads, evaluate_strong);
  CHECK(2 * half.stress.values() == stress.values());
  CHECK(half.failures.failed < failures.failed);
}

TEST_CASE("a particle with two contacts that are both pinned cannot fail at any load") {
  Particles particles(0.016, 2500);
  particles.add(ConvexPolygon{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}}, Motion::free);
  const StressModel<UniformMesher, ConstantStrainTriangle, PlaneStress, TwoPinnedContacts> pinned{};
  const auto op = build_operator(pinned, Rock{}, particles, 0);
  const BreakageModel<> breakage{};
  StressEvaluation evaluate;
  for (const double force : {2e5, 2e9, 2e15}) {
    std::vector<ContactLoad> loads{{{0, 0.008}, {0.1 * force, -force}, force},
                                   {{0, -0.008}, {0, force}, force}};
    const auto find = [&](const auto& support) {
      return evaluate_particle(breakage, support, *op, Rock{}, particles, 0, loads, evaluate)
          .failures.failed;
    };
    CHECK(find(part.support) > 0);  // free
    CHECK(find(pinned.support) == 0);
    CHECK(evaluate_particle(breakage, pinned.support, *op, Rock{}, particles, 0, loads, evaluate)
              .stress.values()
              .isZero(0));
    // A third contact loads it.
    loads.push_back({{0.008, 0}, {-force, 0}, 0});
    CHECK(find(pinned.support) > 0);
  }
}
