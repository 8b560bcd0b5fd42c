// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Weighted mean and central second moments of a cloud of points.

#include <algorithm>
#include <cmath>
#include <span>

#include <riprap/breakage/line_fit/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// Centred sums: the printed form of eq. 5 loses half the digits far from the origin.
struct WeightedMoments {
  Vec2 mean{0, 0};
  double xx = 0;  ///< sum of w (x - mean)^2
  double yy = 0;
  double xy = 0;

  /// A spread below this share of the whole is no spread at all.
  static constexpr double negligible = 1e-12;

  [[nodiscard]] bool spreads_in_x() const { return xx > negligible * (xx + yy); }
  [[nodiscard]] bool spreads_in_y() const { return yy > negligible * (xx + yy); }
};

namespace internal {

/// `v` over its length, also where the square of the length is out of range. `v` must not be zero.
[[nodiscard]] inline Vec2 direction_of(const Vec2& v) {
  const double squared = v.dot(v);
  if (squared > 1e-280 && squared < 1e280) return v / std::sqrt(squared);
  const Vec2 scaled = v / std::max(std::abs(v.x()), std::abs(v.y()));
  return scaled / std::sqrt(scaled.dot(scaled));
}

}  // namespace internal

/// Throws InvalidInput for a position that is not finite, a weight that is negative or not finite,
/// and weights that are all zero.
[[nodiscard]] inline WeightedMoments weighted_moments(std::span<const WeightedPoint> points) {
  WeightedMoments m;
  if (points.empty()) return m;
  double weights = 0;
  Vec2 sum{0, 0};
  for (const WeightedPoint& p : points) {
    require_non_negative("line fit: weight of a point", p.weight);
    require(is_finite(p.position), "line fit: position of a point", p.position.x() + p.position.y(),
            "must be finite");
    weights += p.weight;
    sum += p.weight * (p.position - points[0].position);
  }
  require_positive("line fit: sum of the weights", weights);
  m.mean = points[0].position + sum / weights;
  for (const WeightedPoint& p : points) {
    const Vec2 d = p.position - m.mean;
    m.xx += p.weight * d.x() * d.x();
    m.yy += p.weight * d.y() * d.y();
    m.xy += p.weight * d.x() * d.y();
  }
  require_finite("line fit: second moment of the points", m.xx + m.yy);
  return m;
}

}  // namespace riprap
