// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Stiffness of a sample from its curve of stress against strain.

#include <algorithm>
#include <cstddef>
#include <span>

#include <riprap/core/errors.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap {

/// Slope of the line from the start of loading to a point of the curve of deviator against axial
/// strain. In a biaxial test, plane strain under constant sigma_3, the deviator is sigma_1 -
/// sigma_3 and the axis is that of sigma_1: for an elastic material the slope is E/(1 - nu^2), not
/// E as in a triaxial test.
struct SecantModulus {
  double modulus = 0;       ///< [Pa]
  double axial_strain = 0;  ///< since the start of loading [-]
  double deviator = 0;      ///< since the start of loading [Pa]
};

namespace internal {

inline void validate_curve(std::span<const Vec2> curve) {
  require(curve.size() >= 2, "secant modulus: number of points", static_cast<double>(curve.size()),
          "must be 2 or more");
  for (std::size_t i = 1; i < curve.size(); ++i)
    require(curve[i].x() > curve[i - 1].x(), "axial strain", curve[i].x(), "must ascend");
}

}  // namespace internal

/// At a share of the largest deviator: E_50 of a share of one half, which it is by default. The
/// deviator counts from the first point, and the point is where the curve, straight between its
/// points, first reaches the share. Throws InvalidInput if strains do not ascend or the deviator
/// never exceeds the first one.
/// @param curve axial strain [-] and deviator [Pa], compression positive
/// @param share in (0, 1]
[[nodiscard]] inline SecantModulus secant_modulus_at_share(std::span<const Vec2> curve,
                                                           double share = 0.5) {
  internal::validate_curve(curve);
  require(share > 0 && share <= 1, "share of the largest deviator", share, "must lie in (0, 1]");
  const Vec2& start = curve.front();
  double peak = 0;
  for (const Vec2& p : curve) peak = std::max(peak, p.y() - start.y());
  require_positive("secant modulus: rise of the deviator", peak);
  const double target = share * peak;
  std::size_t i = 1;
  while (curve[i].y() - start.y() < target) ++i;
  const Vec2 before = curve[i - 1] - start;
  const Vec2 after = curve[i] - start;
  const double strain =
      before.x() + (target - before.y()) / (after.y() - before.y()) * (after.x() - before.x());
  return {target / strain, strain, target};
}

/// At an axial strain [-] since the first point, which is above 0 and lies on the curve. Throws
/// InvalidInput otherwise.
[[nodiscard]] inline SecantModulus secant_modulus_at_strain(std::span<const Vec2> curve,
                                                            double strain) {
  internal::validate_curve(curve);
  const Vec2& start = curve.front();
  require(strain > 0 && strain <= curve.back().x() - start.x(), "axial strain", strain,
          "must lie above 0 and on the curve");
  std::size_t i = 1;
  while (curve[i].x() - start.x() < strain && i + 1 < curve.size()) ++i;
  const Vec2 before = curve[i - 1] - start;
  const Vec2 after = curve[i] - start;
  const double deviator =
      before.y() + (strain - before.x()) / (after.x() - before.x()) * (after.y() - before.y());
  return {deviator / strain, strain, deviator};
}

}  // namespace riprap
