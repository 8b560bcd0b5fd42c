// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the line fit: where does the crack run?

#include <concepts>
#include <optional>
#include <span>

#include <riprap/breakage/failure/element_failure.hpp>
#include <riprap/breakage/failure/loaded_particle.hpp>
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

/// `fit(points, planes, mean_stress, particle)` in their place: the contact loads on the particle,
/// its polygon and its rock as well.
template <class F>
concept LineFitByPointsAndLoads =
    requires(const F& fit, const std::span<const WeightedPoint> points, const FailurePlanes& planes,
             const Stress2& mean_stress, const LoadedParticle& particle) {
      { fit(points, planes, mean_stress, particle) } -> std::convertible_to<std::optional<Line>>;
    };

template <class F>
concept LineFitByPoints =
    LineFitByPointsAndLoads<F> || LineFitByMeanStress<F> || LineFitByPlanes<F>;

/// `fit(particle)`: for this call alone no finite elements are evaluated. A fit that also has one
/// of the others gets that.
template <class F>
concept LineFitByLoads =
    !LineFitByPoints<F> && requires(const F& fit, const LoadedParticle& particle) {
      { fit(particle) } -> std::convertible_to<std::optional<Line>>;
    };

template <class F>
concept LineFitCall = LineFitByPoints<F> || LineFitByLoads<F>;

}  // namespace requirements

/// A `LineFit` draws one straight line through the particle, from its failed elements, from the
/// contact loads on it, or from both.
template <class F>
concept LineFit = Policy<F> && requirements::LineFitCall<F>;

/// A line fit that takes the loaded particle alone: it needs no finite elements.
template <class F>
concept LoadLineFit = LineFit<F> && requirements::LineFitByLoads<F>;

/// A line fit that takes the loaded particle, alone or with points.
template <class F>
concept LineFitOfParticle =
    LoadLineFit<F> || (LineFit<F> && requirements::LineFitByPointsAndLoads<F>);

template <class F>
consteval bool check_line_fit() {
  check_policy<F>();
  static_assert(requirements::LineFitCall<F>,
                "riprap: a LineFit must have std::optional<Line> operator()(std::span<const "
                "WeightedPoint>, const FailurePlanes&[, const Stress2&[, const "
                "LoadedParticle&]]) const or operator()(const LoadedParticle&) const");
  return LineFit<F>;
}

/// The line of a fit that needs no particle; it is told the mean stress of it if it takes it.
template <LineFit F>
  requires(!LineFitOfParticle<F>)
[[nodiscard]] std::optional<Line> fit_line(const F& fit, std::span<const WeightedPoint> points,
                                           const FailurePlanes& planes,
                                           const Stress2& mean_stress) {
  if constexpr (requirements::LineFitByMeanStress<F>)
    return fit(points, planes, mean_stress);
  else
    return fit(points, planes);
}

/// The line of any fit, which gets of these what it takes.
template <LineFit F>
[[nodiscard]] std::optional<Line> fit_line(const F& fit, std::span<const WeightedPoint> points,
                                           const FailurePlanes& planes, const Stress2& mean_stress,
                                           const LoadedParticle& particle) {
  if constexpr (LoadLineFit<F>)
    return fit(particle);
  else if constexpr (requirements::LineFitByPointsAndLoads<F>)
    return fit(points, planes, mean_stress, particle);
  else
    return fit_line(fit, points, planes, mean_stress);
}

}  // namespace riprap
