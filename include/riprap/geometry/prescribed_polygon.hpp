// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Random convex polygons whose corners, elongation and angularity follow given distributions.

#include <optional>

#include <riprap/core/distribution.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/core/random.hpp>
#include <riprap/geometry/convex_polygon.hpp>

namespace riprap {

/// What a random polygon is to be. Each quantity is drawn from its distribution, independently, and
/// the polygon is built to have it: moment_elongation to round-off, angularity to 1e-6 of itself
/// (both in geometry/shape_measures.hpp). The mean and the spread of a sample are those of the
/// distributions to its sampling error.
struct PrescribedShape {
  unsigned fewest_corners = 4;
  unsigned most_corners = 7;  ///< any number in between is as likely
  /// Of second moments, long over short [-], 1 or more.
  Distribution elongation = Distribution::normal(1.5, 0.25, 1, 2.5);
  /// Lees' angularity [rad]. Not given: as it comes from corners at random angles. Least possible
  /// is about 2 pi / cos(pi / n) for n corners in an equal-sided polygon, more with elongation.
  std::optional<Distribution> angularity = std::nullopt;
  /// Of the angles between corners, where angularity is not given: from 0, all equal before the
  /// stretch, to 0.95, nearly corners at uniform places on a circle.
  double unevenness = 0.5;

  /// Throws InvalidInput that names the value and the rule.
  void validate() const;
};

/// A random polygon with its centroid at the origin and the area of a circle of the given diameter
/// [m]: corners at random angles on a circle, stretched to the elongation in a random direction.
/// For an angularity the angles are changed until it is met. `shape` must be valid. Throws
/// InvalidInput for an angularity that no polygon of 1,000 has, with the corners and the
/// elongation.
[[nodiscard]] ConvexPolygon random_polygon(const PrescribedShape& shape, double equivalent_diameter,
                                           Random& random);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/geometry/prescribed_polygon.ipp>
#endif
