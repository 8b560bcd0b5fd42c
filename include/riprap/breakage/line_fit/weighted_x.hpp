// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Weighted least squares of horizontal distances: the X method of the paper.

#include <riprap/breakage/line_fit/weighted_moments.hpp>

namespace riprap {

/// x = m y + b with the least sum of w (x - m y - b)^2. No line where the points share one y.
struct WeightedX {
  [[nodiscard]] std::optional<Line> operator()(std::span<const WeightedPoint> points,
                                               const FailurePlanes& /*planes*/) const {
    const WeightedMoments m = weighted_moments(points);
    if (!m.spreads_in_y()) return std::nullopt;
    return Line{m.mean, internal::direction_of({m.xy, m.yy})};
  }
};

static_assert(LineFit<WeightedX>);

}  // namespace riprap
