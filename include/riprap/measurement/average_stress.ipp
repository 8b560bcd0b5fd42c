// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>

#include <riprap/measurement/average_stress.hpp>

namespace riprap {

namespace internal {

RIPRAP_INLINE void require_finite_sum(const Stress2& sum) {
  require_finite("average_stress: sum of contact forces times branch vectors [N m]",
                 sum.s11 + sum.s22 + sum.s12);
}

}  // namespace internal

RIPRAP_INLINE double Ellipse::share_inside(const Vec2& p, const Vec2& q) const {
  // In units of the semi-axes: |p + s (q - p)|^2 = 1.
  const auto scaled = [this](const Vec2& x) -> Vec2 {
    return {(x.x() - centre.x()) / semi_axes.x(), (x.y() - centre.y()) / semi_axes.y()};
  };
  const Vec2 u = scaled(p);
  const Vec2 d = scaled(q) - u;
  const double a = d.dot(d);
  const double b = u.dot(d);
  const double discriminant = b * b - a * (u.dot(u) - 1);
  if (a == 0 || discriminant <= 0) return u.dot(u) < 1 && a == 0 ? 1 : 0;
  const double root = std::sqrt(discriminant);
  const double enter = std::max(0.0, (-b - root) / a);
  const double leave = std::min(1.0, (-b + root) / a);
  return std::max(0.0, leave - enter);
}

RIPRAP_INLINE double sin_phi(const Stress2& stress) {
  const double sum = stress.s22 + stress.s11;
  return sum == 0 ? 0 : (stress.s22 - stress.s11) / sum;
}

}  // namespace riprap
