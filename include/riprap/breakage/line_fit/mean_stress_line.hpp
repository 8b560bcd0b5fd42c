// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Through the centroid, across the major tension of the mean stress.

#include <cmath>

#include <riprap/breakage/line_fit/concepts.hpp>

namespace riprap {

/// Along the direction of sigma_1 of the mean stress of the particle, by the contact loads. No line
/// where that has no deviator.
struct MeanStressLine {
  /// A deviator below this share of the mean normal stress is none.
  static constexpr double negligible = 1e-12;

  [[nodiscard]] std::optional<Line> operator()(const LoadedParticle& particle) const {
    const Stress2 mean = particle.mean_stress();
    if (mean.radius() <= negligible * std::abs(mean.mean())) return std::nullopt;
    return Line{particle.centroid(), mean.principal().major_direction};
  }
};

static_assert(LoadLineFit<MeanStressLine>);

}  // namespace riprap
