// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The line across the mean tension of the failed elements. Converges with the mesh.

#include <cmath>

#include <riprap/breakage/line_fit/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// Through the centroid of the failed area, along the minor axis of the sum of A d d^T: A is the
/// area that a point stands for, d the direction of its minor principal stress, whatever its
/// mode. Without tension, d is that of the least compression: splitting opens along it, and the two
/// shear planes, of which nothing prefers one, lie symmetric to the line across it. Turns with the
/// particle. Weights 1/SF and failure planes play no part.
///
/// A point under equal principal stresses has no d and counts for the centroid only. No line where
/// the sum has equal axes.
struct MeanTensionLine {
  /// A sum whose axes differ by less than this share of its trace has none.
  static constexpr double negligible = 1e-12;

  /// Throws InvalidInput for a position or a stress that is not finite, an area that is negative or
  /// not finite, and areas that are all zero.
  [[nodiscard]] std::optional<Line> operator()(std::span<const WeightedPoint> points,
                                               const FailurePlanes& /*planes*/) const {
    if (points.empty()) return std::nullopt;
    const Vec2 origin = points[0].position;
    double area = 0;
    Vec2 moment{0, 0};
    // The deviator of the sum of A m m^T, m across d: points with the angle of m doubled.
    Vec2 doubled{0, 0};
    for (const WeightedPoint& p : points) {
      require_valid(p);
      area += p.area;
      moment += p.area * (p.position - origin);
      const double radius = p.stress.radius();
      if (radius > 0)
        doubled += p.area * Vec2{0.5 * (p.stress.s11 - p.stress.s22), p.stress.s12} / radius;
    }
    require_positive("line fit: sum of the areas", area);
    if (doubled.norm() <= negligible * area) return std::nullopt;
    const double angle = 0.5 * std::atan2(doubled.y(), doubled.x());
    return Line{origin + moment / area, Vec2{std::cos(angle), std::sin(angle)}};
  }

 private:
  static void require_valid(const WeightedPoint& p) {
    require_non_negative("line fit: area of a point", p.area);
    require(is_finite(p.position), "line fit: position of a point", p.position.x() + p.position.y(),
            "must be finite");
    require_finite("line fit: largest shear stress of a point", p.stress.radius());
  }
};

static_assert(LineFit<MeanTensionLine>);

}  // namespace riprap
