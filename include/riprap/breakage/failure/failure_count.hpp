// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Number and area of the failed elements of a particle, and their ratios to the whole.

#include <limits>

#include <riprap/breakage/failure/element_failure.hpp>
#include <riprap/stress/element/element_stress.hpp>
#include <riprap/stress/sampling_points.hpp>

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
  double failed_area = 0;  ///< that the failed sampling points stand for [m^2]; 0 if not asked for
  double area = 0;         ///< of the particle [m^2]; 0 if not asked for

  /// Rat: failed elements over all elements [-].
  [[nodiscard]] double ratio() const {
    return elements == 0 ? 0 : static_cast<double>(failed) / static_cast<double>(elements);
  }
  /// Failed area over the area of the particle [-].
  [[nodiscard]] double area_ratio() const { return area == 0 ? 0 : failed_area / area; }

  static void for_each_field(auto& self, auto&& visit) {
    visit("elements", self.elements);
    visit("failed", self.failed);
    visit("lowest_safety_factor", self.lowest_safety_factor);
    visit("first_failed", self.first_failed);
    visit("failed_area", self.failed_area);
    visit("area", self.area);
  }
};

namespace internal {

template <Criterion C, class OnFailed>
[[nodiscard]] FailureCount count_failures(const C& criterion, const ElementStress& stress,
                                          OnFailed&& on_failed) {
  FailureCount failures{.elements = stress.size()};
  for (std::size_t e = 0; e < stress.size(); ++e) {
    const ElementFailure element = evaluate(criterion, stress[e]);
    failures.failed += element.failed();
    if (element.failed()) on_failed(e);
    // A failed element has at most 1, an intact one more: the lowest is a failed one if there is
    // any.
    if (element.safety_factor < failures.lowest_safety_factor) {
      failures.lowest_safety_factor = element.safety_factor;
      failures.first_failed = e;
    }
  }
  return failures;
}

}  // namespace internal

/// Evaluates the criterion at every sampling point; leaves the areas out. Throws InvalidInput for a
/// stress that is not finite.
template <Criterion C>
[[nodiscard]] FailureCount count_failures(const C& criterion, const ElementStress& stress) {
  return internal::count_failures(criterion, stress, [](std::size_t) {});
}

/// The same with the failed area.
/// @param samples where `stress` is that of, @param area of the particle [m^2]
template <Criterion C>
[[nodiscard]] FailureCount count_failures(const C& criterion, const ElementStress& stress,
                                          const SamplingPoints& samples, double area) {
  double failed_area = 0;
  FailureCount failures = internal::count_failures(
      criterion, stress, [&](std::size_t e) { failed_area += samples.area(e); });
  failures.failed_area = failed_area;
  failures.area = area;
  return failures;
}

}  // namespace riprap
