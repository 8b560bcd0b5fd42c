// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the breakage trigger.

#include <cstddef>
#include <limits>
#include <utility>

#include <riprap/breakage/trigger/concepts.hpp>
#include <riprap/conformance/violations.hpp>
#include <riprap/core/ids.hpp>

namespace riprap {

/// Which axioms a trigger breaks, for particles of 50 to 200 elements and about `mean_area` [m^2].
template <Trigger T>
[[nodiscard]] Violations trigger_violations(const T& trigger, double mean_area = 2e-4) {
  AxiomCheck check;
  for (const unsigned elements : {50u, 100u, 200u}) {
    bool broken = false;
    for (std::size_t failed = 0; failed <= elements; ++failed) {
      const FailureCount failures{.elements = elements,
                                  .failed = failed,
                                  .lowest_safety_factor =
                                      failed == 0 ? 2.0 : 1.0 / static_cast<double>(failed)};
      const bool breaks = trigger(failures);
      check.at("failed elements", static_cast<double>(failed));
      check.holds("a particle without failed elements stays whole", failed > 0 || !breaks);
      check.holds("one more failed element never prevents a break", breaks || !broken);
      check.holds("the same count gives the same answer", trigger(failures) == breaks);
      if constexpr (requires { trigger.failed_elements_needed(elements); })
        check.holds("a particle with fewer failed elements than are needed stays whole",
                    failed >= trigger.failed_elements_needed(elements) || !breaks);
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
