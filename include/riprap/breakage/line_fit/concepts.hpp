// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the line fit: where does the crack run?

#include <concepts>
#include <optional>
#include <span>

#include <riprap/breakage/failure/element_failure.hpp>
#include <riprap/core/policy.hpp>
#include <riprap/geometry/cut.hpp>

namespace riprap {

/// Failed sampling point of an element, [m], and its weight 1/SF.
struct WeightedPoint {
  Vec2 position{0, 0};
  double weight = 1;
};

namespace requirements {

/// `fit(points, planes)` -> the line, or nothing where the points determine none. `points` are the
/// failed elements only, in laboratory axes; `planes` are the failure planes of the first failed
/// element, by which a fit may choose between lines. Const, for one fit serves all particles.
template <class F>
concept LineFitCall = requires(const F& fit, const std::span<const WeightedPoint> points,
                               const FailurePlanes& planes) {
  { fit(points, planes) } -> std::convertible_to<std::optional<Line>>;
};

}  // namespace requirements

/// A `LineFit` draws one straight line through the failed elements.
template <class F>
concept LineFit = Policy<F> && requirements::LineFitCall<F>;

template <class F>
consteval bool check_line_fit() {
  check_policy<F>();
  static_assert(requirements::LineFitCall<F>,
                "riprap: a LineFit must have std::optional<Line> operator()(std::span<const "
                "WeightedPoint>, const FailurePlanes&) const");
  return LineFit<F>;
}

}  // namespace riprap
