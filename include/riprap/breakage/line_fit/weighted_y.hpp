// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Weighted least squares of vertical distances: the Y method of the paper, eqs 4 and 5.

#include <riprap/breakage/line_fit/weighted_moments.hpp>

namespace riprap {

/// y = m x + b with the least sum of w (y - m x - b)^2. No line where the points share one x.
struct WeightedY {
  [[nodiscard]] std::optional<Line> operator()(std::span<const WeightedPoint> points,
                                               const FailurePlanes& /*planes*/) const {
    const WeightedMoments m = weighted_moments(points);
    if (!m.spreads_in_x()) return std::nullopt;
    return Line{m.mean, internal::direction_of({m.xx, m.xy})};
  }
};

static_assert(LineFit<WeightedY>);

}  // namespace riprap
