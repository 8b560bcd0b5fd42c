#pragma once
/// @file
/// Weighted mean and central second moments of a cloud of points.

#include <span>

#include <riprap/breakage/line_fit/concepts.hpp>

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

[[nodiscard]] inline WeightedMoments weighted_moments(std::span<const WeightedPoint> points) {
  WeightedMoments m;
  if (points.empty()) return m;
  double weights = 0;
  Vec2 sum{0, 0};
  for (const WeightedPoint& p : points) {
    weights += p.weight;
    sum += p.weight * (p.position - points[0].position);
  }
  m.mean = points[0].position + sum / weights;
  for (const WeightedPoint& p : points) {
    const Vec2 d = p.position - m.mean;
    m.xx += p.weight * d.x() * d.x();
    m.yy += p.weight * d.y() * d.y();
    m.xy += p.weight * d.x() * d.y();
  }
  return m;
}

}  // namespace riprap
