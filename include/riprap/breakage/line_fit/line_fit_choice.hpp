// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A line fit chosen at run time: one more model of the role, for programs with options.

#include <variant>

#include <riprap/breakage/line_fit/concepts.hpp>

namespace riprap {

/// Holds one of several line fits and passes on to it what it takes. It needs finite elements
/// unless all of its fits do without, and then it is a LoadLineFit itself.
template <LineFit... Fits>
struct LineFitChoice {
  std::variant<Fits...> chosen;

  [[nodiscard]] std::optional<Line> operator()(std::span<const WeightedPoint> points,
                                               const FailurePlanes& planes,
                                               const Stress2& mean_stress) const
    requires(!LineFitOfParticle<Fits> && ...)
  {
    return std::visit([&](const auto& fit) { return fit_line(fit, points, planes, mean_stress); },
                      chosen);
  }
  [[nodiscard]] std::optional<Line>
  operator()(std::span<const WeightedPoint> points, const FailurePlanes& planes,
             const Stress2& mean_stress, const LoadedParticle& particle) const
    requires((LineFitOfParticle<Fits> || ...) && !(LoadLineFit<Fits> && ...))
  {
    return std::visit(
        [&](const auto& fit) { return fit_line(fit, points, planes, mean_stress, particle); },
        chosen);
  }
  [[nodiscard]] std::optional<Line> operator()(const LoadedParticle& particle) const
    requires(LoadLineFit<Fits> && ...)
  {
    return std::visit([&](const auto& fit) { return std::optional<Line>(fit(particle)); }, chosen);
  }

  static void for_each_field(auto& self, auto&& visit) { visit("chosen", self.chosen); }
};

}  // namespace riprap
