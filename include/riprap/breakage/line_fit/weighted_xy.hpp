// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The paper's choice between the X and the Y method: the default line fit.

#include <riprap/breakage/line_fit/weighted_x.hpp>
#include <riprap/breakage/line_fit/weighted_y.hpp>

namespace riprap {

/// Of the two lines, the one closer to a failure plane of the first failed element; the Y line
/// where they are equally close, the only one where the other does not exist.
struct WeightedXY {
  [[nodiscard]] std::optional<Line> operator()(std::span<const WeightedPoint> points,
                                               const FailurePlanes& planes) const {
    const std::optional<Line> by_x = WeightedX{}(points, planes);
    const std::optional<Line> by_y = WeightedY{}(points, planes);
    if (!by_x || !by_y) return by_x ? by_x : by_y;
    return planes.angle_to(by_x->direction) < planes.angle_to(by_y->direction) ? by_x : by_y;
  }
};

static_assert(LineFit<WeightedXY>);

}  // namespace riprap
