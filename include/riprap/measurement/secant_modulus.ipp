// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <riprap/measurement/secant_modulus.hpp>

namespace riprap {

namespace internal {

RIPRAP_INLINE void validate_curve(std::span<const Vec2> curve) {
  require(curve.size() >= 2, "secant modulus: number of points", static_cast<double>(curve.size()),
          "must be 2 or more");
  for (std::size_t i = 1; i < curve.size(); ++i)
    require(curve[i].x() > curve[i - 1].x(), "axial strain", curve[i].x(), "must ascend");
}

}  // namespace internal

RIPRAP_INLINE SecantModulus secant_modulus_at_share(std::span<const Vec2> curve, double share) {
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

RIPRAP_INLINE SecantModulus secant_modulus_at_strain(std::span<const Vec2> curve, double strain) {
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
