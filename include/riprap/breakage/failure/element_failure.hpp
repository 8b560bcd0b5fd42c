// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Has an element failed, how, and along which planes: eqs 2, 3 and 6 of the paper.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>

#include <riprap/breakage/criterion/concepts.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/stress2.hpp>

namespace riprap {

/// How an element has failed.
enum class FailureMode : std::uint8_t { intact, tension, shear };

[[nodiscard]] constexpr const char* to_text(FailureMode mode) {
  return mode == FailureMode::tension ? "tension" : mode == FailureMode::shear ? "shear" : "intact";
}

/// Mode and safety factor of one element.
struct ElementFailure {
  FailureMode mode = FailureMode::intact;
  double safety_factor = std::numeric_limits<double>::infinity();

  [[nodiscard]] bool failed() const { return mode != FailureMode::intact; }
  /// Weight of the element in the line fit, eq. 3.
  [[nodiscard]] double weight() const { return 1 / safety_factor; }
};

namespace internal {

[[noreturn, gnu::cold, gnu::noinline]] inline void throw_not_finite(const Stress2& stress) {
  throw InvalidInput("evaluate: stress (" + to_text(stress.s11) + ", " + to_text(stress.s22) +
                     ", " + to_text(stress.s12) + ") Pa: must be finite");
}
[[noreturn, gnu::cold, gnu::noinline]] inline void throw_no_strength(double minor, double limit) {
  throw InvalidInput("criterion: major_stress_at_failure(" + to_text(minor) +
                     " Pa) = " + to_text(limit) + ": must be a number");
}

}  // namespace internal

/// Eq. 2, compression positive. Tension first: sigma_3 <= -sigma_t, SF = sigma_t / |sigma_3|. Then
/// shear: sigma_1 >= sigma_1f, SF = sigma_1f / sigma_1. An intact element without compression has
/// no ratio: infinity. In the narrow band next to the tensile strength where sigma_1f itself is not
/// positive, the ratio of eq. 2 has no meaning; such an element counts as failed in tension. Just
/// above that band sigma_1f is small and the ratio, as eq. 2 has it, falls towards 0: one such
/// element can outweigh all others in the line fit.
/// Throws InvalidInput for a stress, or a strength of the criterion, that is not a number.
template <Criterion C>
[[nodiscard]] ElementFailure evaluate(const C& criterion, const Stress2& stress) {
  const PrincipalValues in_plane = stress.principal_values();
  // Any component that is not finite makes the difference NaN or infinite.
  if (!(in_plane.major - in_plane.minor < std::numeric_limits<double>::infinity()))
    internal::throw_not_finite(stress);
  const auto [major, minor] = extreme_stresses(criterion, in_plane);
  const double tensile = criterion.tensile_strength();
  if (minor <= -tensile) return {FailureMode::tension, tensile / -minor};
  const double limit = criterion.major_stress_at_failure(minor);
  if (major >= limit) {
    if (limit <= 0) return {FailureMode::tension, std::min(1.0, tensile / std::abs(minor))};
    return {FailureMode::shear, limit / major};
  }
  if (!(major < limit)) internal::throw_no_strength(minor, limit);
  if (major > 0) return {FailureMode::intact, limit / major};
  return {};
}

/// One or two candidate directions of the crack, as unit vectors.
struct FailurePlanes {
  std::array<Vec2, 2> directions{Vec2{1, 0}, Vec2{1, 0}};
  std::size_t count = 0;

  [[nodiscard]] std::span<const Vec2> span() const& { return {directions.data(), count}; }
  [[nodiscard]] std::span<const Vec2> span() const&& = delete;  // would outlive the planes

  /// Smallest angle [rad] between a direction and one of the planes.
  [[nodiscard]] double angle_to(const Vec2& direction) const {
    double least = 0.5 * std::numbers::pi;
    for (const Vec2& plane : span())
      least = std::min(
          least, std::atan2(std::abs(cross(plane, direction)), std::abs(plane.dot(direction))));
    return least;
  }
};

/// Eq. 6 and Fig. 2 put right: a tensile crack runs across the largest tension, along the major
/// direction; shear planes lie at +-(pi/4 - phi/2) from the major direction. Where the smallest
/// principal stress is that out of the plane, the shear planes are inclined to the plane and meet
/// it across the major direction.
template <Criterion C>
[[nodiscard]] FailurePlanes failure_planes(const C& criterion, const Stress2& stress,
                                           FailureMode mode) {
  const PrincipalStress principal = stress.principal();
  FailurePlanes planes;
  if (mode == FailureMode::tension) {
    planes.directions[0] = principal.major_direction;
    planes.count = 1;
  } else if (mode == FailureMode::shear) {
    if (extreme_stresses(criterion, {principal.major, principal.minor}).minor < principal.minor)
      return {{perpendicular(principal.major_direction), Vec2{1, 0}}, 1};
    const double off = std::numbers::pi / 4 - 0.5 * friction_angle(criterion, principal.minor);
    const Rotation turn = Rotation::from_angle(off);
    planes.directions[0] = turn * principal.major_direction;
    planes.directions[1] = turn.inverse_times(principal.major_direction);
    planes.count = 2;
  }
  return planes;
}

}  // namespace riprap
