// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the line fit: where does the crack run?

#include <concepts>
#include <optional>
#include <span>

#include <riprap/breakage/failure/element_failure.hpp>
#include <riprap/core/policy.hpp>
#include <riprap/core/stress2.hpp>
#include <riprap/geometry/cut.hpp>

namespace riprap {

/// Failed sampling point of an element, in laboratory axes.
struct WeightedPoint {
  Vec2 position{0, 0};  ///< [m]
  double weight = 1;    ///< 1/SF
  double area = 1;      ///< that the point stands for [m^2]
  Stress2 stress{};     ///< [Pa], compression positive
};

namespace requirements {

/// `fit(points, planes)` -> the line, or nothing where the points determine none. `points` are the
/// failed elements only, in laboratory axes; `planes` are the failure planes of the first failed
/// element, by which a fit may choose between lines. Const, for one fit serves all particles.
template <class F>
concept LineFitByPlanes = requires(const F& fit, const std::span<const WeightedPoint> points,
                                   const FailurePlanes& planes) {
  { fit(points, planes) } -> std::convertible_to<std::optional<Line>>;
};

/// `fit(points, planes, mean_stress)` in its place: the mean stress of the particle as well [Pa],
/// in laboratory axes. A fit that has both calls gets the mean stress.
template <class F>
concept LineFitByMeanStress = requires(const F& fit, const std::span<const WeightedPoint> points,
                                       const FailurePlanes& planes, const Stress2& mean_stress) {
  { fit(points, planes, mean_stress) } -> std::convertible_to<std::optional<Line>>;
};

template <class F>
concept LineFitCall = LineFitByPlanes<F> || LineFitByMeanStress<F>;

}  // namespace requirements

/// A `LineFit` draws one straight line through the failed elements.
template <class F>
concept LineFit = Policy<F> && requirements::LineFitCall<F>;

template <class F>
consteval bool check_line_fit() {
  check_policy<F>();
  static_assert(requirements::LineFitCall<F>,
                "riprap: a LineFit must have std::optional<Line> operator()(std::span<const "
                "WeightedPoint>, const FailurePlanes&[, const Stress2&]) const");
  return LineFit<F>;
}

/// The line of a fit, which is told the mean stress of the particle if it takes it.
template <LineFit F>
[[nodiscard]] std::optional<Line> fit_line(const F& fit, std::span<const WeightedPoint> points,
                                           const FailurePlanes& planes,
                                           const Stress2& mean_stress) {
  if constexpr (requirements::LineFitByMeanStress<F>)
    return fit(points, planes, mean_stress);
  else
    return fit(points, planes);
}

}  // namespace riprap
