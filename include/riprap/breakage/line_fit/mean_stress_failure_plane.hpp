// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Through the centroid, along the failure plane of the mean stress.

#include <limits>

#include <riprap/breakage/line_fit/mean_stress_line.hpp>
#include <riprap/geometry/chord_length.hpp>

namespace riprap {

/// Where the mean stress fails in shear by the criterion of the model, of the two shear planes the
/// one with the shorter cut, by which less rock is torn; else that of MeanStressLine, and none
/// where that has none.
struct MeanStressFailurePlane {
  /// A cut is shorter if it is so by more than this share: those of a symmetric particle are equal.
  static constexpr double round_off = 1e-9;

  [[nodiscard]] std::optional<Line> operator()(const LoadedParticle& particle) const {
    std::optional<Line> best = MeanStressLine{}(particle);
    const Stress2 mean = particle.mean_stress();
    if (!best || particle.criterion().evaluate(mean).mode != FailureMode::shear) return best;
    double shortest = std::numeric_limits<double>::infinity();
    const FailurePlanes planes = particle.criterion().failure_planes(mean, FailureMode::shear);
    for (const Vec2& direction : planes.span()) {
      const Line line{particle.centroid(), direction};
      const double length = chord_length(particle.ring(), line);
      if (length < (1 - round_off) * shortest) {
        shortest = length;
        best = line;
      }
    }
    return best;
  }
};

static_assert(LoadLineFit<MeanStressFailurePlane>);

}  // namespace riprap
