// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The paper's X or Y line, chosen by the mean stress of the particle.

#include <cmath>

#include <riprap/breakage/line_fit/weighted_xy.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// Of the X and the Y line, the one nearer to the plane across the most tensile principal direction
/// of the particle's mean stress. The mean stress follows from the loads alone; failure planes of
/// single elements, by which WeightedXY chooses, do not converge with the mesh.
///
/// The Y line where they are equally near and where the mean stress has no deviator; the only one
/// where the other does not exist.
struct WeightedXYByMeanStress {
  /// A deviator below this share of the mean normal stress is none.
  static constexpr double negligible = 1e-12;

  [[nodiscard]] std::optional<Line> operator()(std::span<const WeightedPoint> points,
                                               const FailurePlanes& /*planes*/,
                                               const Stress2& mean_stress) const {
    const double radius = mean_stress.radius();
    require_finite("line fit: mean stress of the particle", mean_stress.mean() + radius);
    FailurePlanes across;
    if (radius > negligible * std::abs(mean_stress.mean())) {
      across.directions[0] = mean_stress.principal().major_direction;
      across.count = 1;
    }
    return WeightedXY{}(points, across);
  }
};

static_assert(LineFit<WeightedXYByMeanStress>);

}  // namespace riprap
