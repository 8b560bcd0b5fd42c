#pragma once
/// @file
/// The role of the line fit: where does the crack run?

#include <concepts>
#include <optional>
#include <span>

#include <riprap/breakage/element_failure.hpp>
#include <riprap/geometry/cut.hpp>

namespace riprap {

/// Centroid of a failed element [m] and its weight 1/SF.
struct WeightedPoint {
  Vec2 position{0, 0};
  double weight = 1;
};

/// A `LineFit` draws one straight line through the failed elements.
///
/// - `fit(points, planes)` -> the line, or nothing where the points determine none. `points` are
/// the
///   failed elements only, in laboratory axes; `planes` are the failure planes of the first failed
///   element.
template <class F>
concept LineFit =
    requires(const F& fit, std::span<const WeightedPoint> points, const FailurePlanes& planes) {
      { fit(points, planes) } -> std::convertible_to<std::optional<Line>>;
    };

}  // namespace riprap
