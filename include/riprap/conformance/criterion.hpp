// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the failure criterion.

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <riprap/breakage/failure/element_failure.hpp>
#include <riprap/conformance/units.hpp>
#include <riprap/conformance/violations.hpp>

namespace riprap {
namespace internal {

/// What screening relies on, over states of stress up to three times the uniaxial strength.
template <OutOfPlaneCriterion C>
void check_extreme_stresses(const C& criterion, AxiomCheck& check) {
  const double tensile = criterion.tensile_strength();
  const double uniaxial = criterion.major_stress_at_failure(0);
  const double step = 0.05 * (std::isfinite(uniaxial) ? uniaxial : tensile);
  for (double major = -tensile; major < 60 * step; major += step)
    for (double minor = major; minor > -tensile; minor -= step) {
      check.at("sigma_1 in the plane", major);
      const PrincipalValues extremes = extreme_stresses(criterion, {major, minor});
      check.at_least("the largest stress is not below those in the plane", extremes.major, major);
      check.at_most("the smallest stress is not above those in the plane", extremes.minor, minor);
      if (evaluate(criterion, Stress2{major, minor, 0}).failed()) continue;
      for (const double rise : {0.01 * (major - minor), 0.3 * (major - minor), major - minor}) {
        check.holds("an intact element stays so if its minor stress in the plane rises",
                    !evaluate(criterion, Stress2{major, minor + rise, 0}).failed());
        check.holds("an intact element stays so if its stresses in the plane come closer",
                    !evaluate(criterion, Stress2{major - rise / 2, minor + rise / 2, 0}).failed());
      }
    }
}

}  // namespace internal

/// Which axioms a failure criterion breaks for minor stresses from its tensile strength to ten
/// times that in compression. A criterion that never fails has none; where the major stress at
/// failure is infinite (failure in tension only) those about the curve are left out.
/// @param uniaxial the compressive strength that it is meant to have [Pa]; NaN: none in particular
template <Criterion C>
[[nodiscard]] Violations
criterion_violations(const C& criterion,
                     double uniaxial = std::numeric_limits<double>::quiet_NaN()) {
  AxiomCheck check;
  if (never_fails<C>) return {};
  const double tensile = criterion.tensile_strength();
  check.at_least("the tensile strength is above zero", tensile, std::numeric_limits<double>::min());
  check.equal("at the tensile strength the safety factor is 1",
              evaluate(criterion, Stress2{0, -tensile, 0}).safety_factor, 1, 1e-12);
  if (!std::isnan(uniaxial))
    check.equal("at the uniaxial compressive strength the safety factor is 1",
                evaluate(criterion, Stress2{uniaxial, 0, 0}).safety_factor, 1, 1e-6);

  if constexpr (OutOfPlaneCriterion<C>) internal::check_extreme_stresses(criterion, check);

  constexpr int samples = 440;
  double minor = -tensile;
  double limit = criterion.major_stress_at_failure(minor);
  for (int i = 1; i <= samples; ++i) {
    const double next = -tensile + 11 * tensile * i / samples;
    const double next_limit = criterion.major_stress_at_failure(next);
    check.at("sigma_3", next);
    check.holds("the major stress at failure is a number", !std::isnan(next_limit));
    if (std::isinf(limit) && std::isinf(next_limit)) continue;
    const double round_off = 1e-14 * (std::abs(next_limit) + tensile);
    check.at_least("the curve rises at least as fast as sigma_3", next_limit - limit,
                   next - minor - round_off);
    check.at_least("equal stresses fail in tension only: major stress at failure", next_limit,
                   next - round_off);
    // A slope by difference over 1e-6 of the stress has half the digits.
    const double angle = friction_angle(criterion, next);
    check.at_least("the friction angle is not negative", angle, -1e-6);
    check.at_most("the friction angle is below a right one", angle,
                  std::nextafter(0.5 * std::numbers::pi, 0.0));
    minor = next;
    limit = next_limit;
  }
  return std::move(check).violations();
}

/// Which results change, beyond their unit, when the same criterion is written in other units.
/// @param other `criterion` with its parameters in `units`
template <Criterion C>
[[nodiscard]] Violations criterion_unit_violations(const C& criterion, const C& other,
                                                   const Units& units = {}) {
  AxiomCheck check;
  if (never_fails<C>) return {};
  const double tensile = criterion.tensile_strength();
  check.equal("the tensile strength is the same in other units",
              other.tensile_strength() / units.stress(), tensile, 1e-12 * tensile);
  for (int i = 1; i <= 100; ++i) {
    const double minor = tensile * (0.1 * i - 1);
    check.at("sigma_3", minor);
    const double limit = criterion.major_stress_at_failure(minor);
    check.equal("the major stress at failure is the same in other units",
                other.major_stress_at_failure(units.stress() * minor) / units.stress(), limit,
                1e-12 * std::abs(limit));
    if (std::isfinite(limit))
      check.equal("the friction angle is the same in other units",
                  friction_angle(other, units.stress() * minor), friction_angle(criterion, minor),
                  1e-6);
  }
  return std::move(check).violations();
}

}  // namespace riprap
