// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The failure plane of the first failed element, through the weighted centroid of all.

#include <riprap/breakage/line_fit/weighted_moments.hpp>

namespace riprap {

/// Takes its direction from the rock, not from the cloud; of two shear planes the one that lies
/// closer to the points (smaller weighted sum of squared distances). Turns with the particle.
struct FailurePlaneThroughCentroid {
  [[nodiscard]] std::optional<Line> operator()(std::span<const WeightedPoint> points,
                                               const FailurePlanes& planes) const {
    if (points.empty() || planes.count == 0) return std::nullopt;
    const WeightedMoments m = weighted_moments(points);
    const auto misfit = [&m](const Vec2& d) {
      return m.xx * d.y() * d.y() - 2 * m.xy * d.x() * d.y() + m.yy * d.x() * d.x();
    };
    Vec2 best = planes.directions[0];
    for (const Vec2& direction : planes.span()) {
      require(is_finite(direction), "line fit: direction of a failure plane",
              direction.x() + direction.y(), "must be finite");
      if (misfit(direction) < misfit(best)) best = direction;
    }
    return Line{m.mean, best};
  }
};

static_assert(LineFit<FailurePlaneThroughCentroid>);

}  // namespace riprap
