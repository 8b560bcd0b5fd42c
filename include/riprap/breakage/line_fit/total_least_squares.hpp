// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Weighted least squares of distances across the line: turns with the particle, unlike X and Y.

#include <cmath>

#include <riprap/breakage/line_fit/weighted_moments.hpp>

namespace riprap {

/// The major principal axis of the weighted cloud (Pearson 1901). No line where the cloud has none.
struct TotalLeastSquares {
  [[nodiscard]] std::optional<Line> operator()(std::span<const WeightedPoint> points,
                                               const FailurePlanes& /*planes*/) const {
    const WeightedMoments m = weighted_moments(points);
    const double half = 0.5 * (m.xx - m.yy);
    if (std::hypot(half, m.xy) <= WeightedMoments::negligible * (m.xx + m.yy)) return std::nullopt;
    const double angle = 0.5 * std::atan2(m.xy, half);
    return Line{m.mean, Vec2{std::cos(angle), std::sin(angle)}};
  }
};

static_assert(LineFit<TotalLeastSquares>);

}  // namespace riprap
