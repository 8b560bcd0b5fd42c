// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Number of failed elements of a particle, and the ratio Rat.

#include <limits>

#include <riprap/breakage/failure/element_failure.hpp>
#include <riprap/stress/element/element_stress.hpp>

namespace riprap {

/// Count over the elements of one particle in one evaluation. Elements are counted by their
/// sampling points, of which the constant-strain triangle has one.
struct FailureCount {
  std::size_t elements = 0;
  std::size_t failed = 0;
  /// Lowest safety factor and the sampling point it belongs to, ties by index. Where any element
  /// has failed this is the paper's first failed element: a property of one evaluation, not of
  /// history.
  double lowest_safety_factor = std::numeric_limits<double>::infinity();
  std::size_t first_failed = 0;

  /// Rat: failed elements over all elements [-].
  [[nodiscard]] double ratio() const {
    return elements == 0 ? 0 : static_cast<double>(failed) / static_cast<double>(elements);
  }
};

/// Evaluates the criterion at every sampling point. Throws InvalidInput for a stress that is not
/// finite.
template <Criterion C>
[[nodiscard]] FailureCount count_failures(const C& criterion, const ElementStress& stress) {
  FailureCount failures{.elements = stress.size()};
  for (std::size_t e = 0; e < stress.size(); ++e) {
    const ElementFailure element = evaluate(criterion, stress[e]);
    failures.failed += element.failed();
    // A failed element has at most 1, an intact one more: the lowest is a failed one if there is
    // any.
    if (element.safety_factor < failures.lowest_safety_factor) {
      failures.lowest_safety_factor = element.safety_factor;
      failures.first_failed = e;
    }
  }
  return failures;
}

}  // namespace riprap
