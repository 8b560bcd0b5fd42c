// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The rectangle of least area around a polygon. Optional: not part of riprap.hpp.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/convex_hull.hpp>
#include <riprap/geometry/line_side.hpp>
#include <riprap/geometry/polygon_properties.hpp>

namespace riprap {

/// Sides of a rectangle, the longer one first, and its direction.
struct BoundingRectangle {
  double length = 0;        ///< [m]
  double width = 0;         ///< [m]
  Vec2 direction = {1, 0};  ///< unit vector along the longer side

  [[nodiscard]] double area() const { return length * width; }  ///< [m^2]
};

/// The rectangle of least area around a simple ring, convex or not. One of its sides lies along an
/// edge of the convex hull (H. Freeman, R. Shapira, Commun. ACM 18, 1975); of equal ones the first.
[[nodiscard]] inline BoundingRectangle least_area_rectangle(Ring ring) {
  const std::vector<Vec2> hull = convex_hull(ring);
  BoundingRectangle best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < hull.size(); ++k) {
    const Vec2 edge = hull[next_vertex(k, hull.size())] - hull[k];
    const Vec2 along = edge / edge.norm();
    const double length = extent_along(hull, along);
    const double width = extent_along(hull, perpendicular(along));
    if (length * width >= least) continue;
    least = length * width;
    best = {length, width, along};
    if (width > length) best = {width, length, perpendicular(along)};
  }
  return best;
}

}  // namespace riprap
