// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Random convex polygons with sharp corners.

#include <numbers>
#include <vector>

#include <riprap/core/linkage.hpp>
#include <riprap/core/random.hpp>
#include <riprap/geometry/convex_polygon.hpp>

namespace riprap {

/// Vertices at jittered angles on an ellipse. Sharpness decides much of what an assembly does (with
/// blunt parents the pieces are sharper than the particles they came from), so shape is stated.
/// The defaults give a mean smallest corner of about 65 degrees and a mean aspect of about 1.72.
struct PolygonShape {
  unsigned fewest_vertices = 3;
  unsigned most_vertices = 5;
  double smallest_axis_ratio = 0.65;  ///< of the ellipse [-], in (0, 1]
  double largest_axis_ratio = 1;      ///< [-]
  double angle_jitter = 0.8;          ///< share of the angular step, in [0, 1)

  /// Throws InvalidInput that names the value and the rule.
  void validate() const;
};

/// A random polygon with its centroid at the origin and the area of a circle of the given diameter
/// [m]. `shape` must be valid.
[[nodiscard]] ConvexPolygon random_polygon(const PolygonShape& shape, double equivalent_diameter,
                                           Random& random);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/geometry/random_polygon.ipp>
#endif
