// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the breakage trigger.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>

#include <riprap/breakage/trigger/concepts.hpp>
#include <riprap/conformance/violations.hpp>
#include <riprap/core/ids.hpp>

namespace riprap {
namespace internal {

/// A fan of triangles, of which each is smaller than the one before; the last has half of the area
/// of the first.
[[nodiscard]] inline Mesh falling_areas(unsigned elements) {
  Mesh mesh;
  mesh.nodes = {{0, 0}};
  for (std::uint32_t e = 0; e <= elements; ++e) {
    mesh.nodes.push_back({1, e == 0 ? 0 : mesh.nodes[e].y() + 1 - 0.5 * (e - 1) / elements});
    if (e > 0) mesh.triangles.push_back({0, e, e + 1});
  }
  return mesh;
}

}  // namespace internal

/// Which axioms a trigger breaks, for particles of 50 to 200 elements and about `mean_area` [m^2].
/// The elements fail from the largest to the smallest.
template <Trigger T>
[[nodiscard]] Violations trigger_violations(const T& trigger, double mean_area = 2e-4) {
  AxiomCheck check;
  for (const unsigned elements : {50u, 100u, 200u}) {
    bool broken = false;
    const Mesh mesh = internal::falling_areas(elements);
    const SamplingPoints samples(mesh);
    double area = 0;
    for (std::size_t e = 0; e < elements; ++e) area += samples.area(e);
    double failed_area = 0;
    for (std::size_t failed = 0; failed <= elements; ++failed) {
      const FailureCount failures{.elements = elements,
                                  .failed = failed,
                                  .lowest_safety_factor =
                                      failed == 0 ? 2.0 : 1.0 / static_cast<double>(failed),
                                  .failed_area = failed_area,
                                  .area = area};
      if (failed < elements) failed_area += samples.area(failed);
      const bool breaks = trigger(failures);
      check.at("failed elements", static_cast<double>(failed));
      check.holds("a particle without failed elements stays whole", failed > 0 || !breaks);
      check.holds("one more failed element never prevents a break", breaks || !broken);
      check.holds("the same count gives the same answer", trigger(failures) == breaks);
      if constexpr (requires { trigger.failed_elements_needed(failed); })
        check.holds("a particle with fewer failed elements than are needed stays whole",
                    failed >= trigger.failed_elements_needed(elements) || !breaks);
      if constexpr (requires { trigger.failed_area_needed(); })
        check.holds("a particle with less failed area than is needed stays whole",
                    failures.area_ratio() >= trigger.failed_area_needed() || !breaks);
      broken = breaks;
    }
  }
  if constexpr (requires { trigger.strength_factor(ParticleId{}, mean_area); })
    for (ParticleId id = 0; id < 1000; ++id)
      for (const double area : {0.1 * mean_area, mean_area, 10 * mean_area}) {
        const double factor = trigger.strength_factor(id, area);
        check.at("particle", id);
        check.at_least("a strength factor is above zero", factor,
                       std::numeric_limits<double>::min());
        check.at_most("a strength factor is finite", factor, std::numeric_limits<double>::max());
        check.equal("a particle keeps its strength factor", trigger.strength_factor(id, area),
                    factor, 0);
      }
  return std::move(check).violations();
}

}  // namespace riprap
