// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Area, centroid, polar inertia, perimeter, diameter, extent and least width of a ring of
/// vertices.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <riprap/core/linkage.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap {

/// Area [m^2], centroid [m] and polar second moment of area about the centroid [m^4].
struct AreaProperties {
  double area = 0;
  Vec2 centroid{0, 0};
  double polar_moment = 0;
};

/// Diameter of the circle of equal area [m].
[[nodiscard]] inline double equivalent_diameter(double area) {
  return std::sqrt(4 * area / std::numbers::pi);
}

/// Exact for any simple counter-clockwise ring. Computed relative to the first vertex, so that
/// digits survive far from the origin.
[[nodiscard]] AreaProperties area_properties(Ring ring);

/// The area alone [m^2], the same to the last bit.
[[nodiscard]] double polygon_area(Ring ring);

/// Length of all edges [m].
[[nodiscard]] double perimeter(Ring ring);

/// Largest distance between two vertices [m].
[[nodiscard]] double diameter(Ring ring);

/// Length of the ring's projection on an axis, a unit vector [m].
[[nodiscard]] double extent_along(Ring ring, const Vec2& axis);

/// Smallest distance between two parallel lines that hold a convex ring between them [m].
[[nodiscard]] double least_width(Ring ring);

/// Diameter over least width [-], >= 1.
[[nodiscard]] inline double aspect(Ring ring) { return diameter(ring) / least_width(ring); }

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/geometry/polygon_properties.ipp>
#endif
