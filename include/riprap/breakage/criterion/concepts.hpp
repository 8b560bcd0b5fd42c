// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the failure criterion, and what derives from any model of it.

#include <cmath>
#include <concepts>
#include <cstddef>
#include <limits>
#include <numbers>

#include <riprap/core/ids.hpp>
#include <riprap/core/policy.hpp>
#include <riprap/core/stress2.hpp>

namespace riprap {

namespace requirements {

/// `criterion.major_stress_at_failure(minor)` [Pa]: sigma_1f for a given sigma_3; must rise at
/// least as fast as sigma_3 does. Safety factor, mode and friction angle all derive from it.
template <class C>
concept CriterionCurve = requires(const C& criterion, const double minor) {
  { criterion.major_stress_at_failure(minor) } -> std::convertible_to<double>;
};

/// `criterion.tensile_strength()` [Pa], positive: an element fails in tension where
/// sigma_3 <= -tensile_strength. Required because the curve need not end in its own apex.
template <class C>
concept CriterionTension = requires(const C& criterion) {
  { criterion.tensile_strength() } -> std::convertible_to<double>;
};

/// Optional: `criterion.friction_angle(minor)` [rad]; else it follows from the slope of the curve.
/// A non-const function would be ignored silently.
template <class C>
concept CriterionAngle = !requires(C& criterion, double minor) {
  criterion.friction_angle(minor);
} || requires(const C& criterion, const double minor) {
  { criterion.friction_angle(minor) } -> std::convertible_to<double>;
};

/// Optional: `criterion.extreme_stresses(in_plane)` [Pa]: the largest and the smallest of the three
/// principal stresses, by which an element fails, from the two in the plane; else it fails by
/// those. Screening relies on this: an element that is intact stays so if its minor stress in the
/// plane rises up to the major one, or if both come closer by the same amount.
template <class C>
concept CriterionExtremes = !requires(C& criterion, PrincipalValues& in_plane) {
  criterion.extreme_stresses(in_plane);
} || requires(const C& criterion, const PrincipalValues& in_plane) {
  { criterion.extreme_stresses(in_plane) } -> std::convertible_to<PrincipalValues>;
};

/// Optional: `criterion.of_material(material)` -> the criterion of a particle of that material, and
/// `criterion.materials()`, for how many it has one. Its own curve is then a lower bound on theirs.
/// Non-const functions would be ignored silently.
template <class C>
concept CriterionMaterials = !requires(C& criterion, MaterialIndex material) {
  criterion.of_material(material);
} || requires(const C& criterion, const MaterialIndex material, const double minor) {
  { criterion.of_material(material).major_stress_at_failure(minor) } -> std::convertible_to<double>;
  { criterion.of_material(material).tensile_strength() } -> std::convertible_to<double>;
  { criterion.materials() } -> std::convertible_to<std::size_t>;
};

}  // namespace requirements

/// A `Criterion` is a curve in the plane of the principal stresses, compression positive.
///
/// Optional: `C::never_fails == true`, and the stress analysis is left out of the program.
template <class C>
concept Criterion = Policy<C> && requirements::CriterionCurve<C> &&
                    requirements::CriterionTension<C> && requirements::CriterionAngle<C> &&
                    requirements::CriterionExtremes<C> && requirements::CriterionMaterials<C>;

/// A criterion by which an element may fail in planes that are inclined to its own.
template <class C>
concept OutOfPlaneCriterion =
    Criterion<C> && requires(const C& criterion, const PrincipalValues& in_plane) {
      criterion.extreme_stresses(in_plane);
    };

/// A criterion that differs from material to material.
template <class C>
concept MaterialCriterion = Criterion<C> && requires(const C& criterion, MaterialIndex material) {
  criterion.of_material(material);
};

template <class C>
consteval bool check_criterion() {
  check_policy<C>();
  static_assert(requirements::CriterionCurve<C>,
                "riprap: a Criterion must have double major_stress_at_failure(double minor) const");
  static_assert(requirements::CriterionTension<C>,
                "riprap: a Criterion must have double tensile_strength() const");
  static_assert(requirements::CriterionAngle<C>,
                "riprap: friction_angle of a Criterion must be double friction_angle(double "
                "minor) const");
  static_assert(requirements::CriterionExtremes<C>,
                "riprap: extreme_stresses of a Criterion must be PrincipalValues "
                "extreme_stresses(const PrincipalValues& in_plane) const");
  static_assert(requirements::CriterionMaterials<C>,
                "riprap: of_material of a Criterion must be const and return a Criterion, beside "
                "std::size_t materials() const");
  return Criterion<C>;
}

/// The criterion of a material: the one itself where it is the same for all.
template <Criterion C>
[[nodiscard]] const auto& criterion_of(const C& criterion, MaterialIndex material) {
  if constexpr (MaterialCriterion<C>)
    return criterion.of_material(material);
  else
    return criterion;
}

/// True for a criterion that declares that nothing ever fails by it.
template <class C>
inline constexpr bool never_fails = [] {
  if constexpr (requires { C::never_fails; })
    return static_cast<bool>(C::never_fails);
  else
    return false;
}();

/// The stresses by which an element fails [Pa]: those in the plane unless the criterion says
/// otherwise.
template <Criterion C>
[[nodiscard]] PrincipalValues extreme_stresses(const C& criterion,
                                               const PrincipalValues& in_plane) {
  if constexpr (OutOfPlaneCriterion<C>)
    return criterion.extreme_stresses(in_plane);
  else
    return in_plane;
}

/// Friction angle [rad] from the slope k = d sigma_1f / d sigma_3 of a failure curve:
/// sin phi = (k - 1) / (k + 1).
[[nodiscard]] inline double friction_angle_from_slope(double slope) {
  return std::asin((slope - 1) / (slope + 1));
}

/// Friction angle [rad] at sigma_3 = minor [Pa]: the criterion's own where it has one, else from
/// the slope of its curve by a difference towards compression, where the curve is defined.
template <Criterion C>
[[nodiscard]] double friction_angle(const C& criterion, double minor) {
  if constexpr (requires { criterion.friction_angle(minor); }) {
    return criterion.friction_angle(minor);
  } else {
    const double step = 1e-6 * (std::abs(minor) + criterion.tensile_strength());
    const double slope = (criterion.major_stress_at_failure(minor + step) -
                          criterion.major_stress_at_failure(minor)) /
                         step;
    return friction_angle_from_slope(slope);
  }
}

}  // namespace riprap
