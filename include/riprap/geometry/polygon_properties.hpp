// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Area, centroid, polar inertia, diameter, extent and least width of a ring of vertices.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

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
[[nodiscard]] inline AreaProperties area_properties(Ring ring) {
  if (ring.size() < 3) return {0, ring.empty() ? Vec2{0, 0} : ring[0], 0};
  const Vec2 origin = ring[0];
  double twice_area = 0;
  Vec2 first{0, 0};
  double second = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Vec2 p = ring[i] - origin;
    const Vec2 q = ring[i + 1] - origin;
    const double t = cross(p, q);
    twice_area += t;
    first += t * (p + q);
    second += t * (p.dot(p) + p.dot(q) + q.dot(q));
  }
  const Vec2 c = twice_area != 0 ? Vec2(first / (3 * twice_area)) : Vec2{0, 0};
  const double area = 0.5 * twice_area;
  return {area, origin + c, second / 12 - area * c.dot(c)};
}

/// The area alone [m^2], the same to the last bit.
[[nodiscard]] inline double polygon_area(Ring ring) {
  double twice_area = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    twice_area += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return 0.5 * twice_area;
}

/// Largest distance between two vertices [m].
[[nodiscard]] inline double diameter(Ring ring) {
  double squared = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    for (std::size_t j = i + 1; j < ring.size(); ++j)
      squared = std::max(squared, (ring[i] - ring[j]).squaredNorm());
  return std::sqrt(squared);
}

/// Length of the ring's shadow on an axis, a unit vector [m].
[[nodiscard]] inline double extent_along(Ring ring, const Vec2& axis) {
  double low = axis.dot(ring[0]);
  double high = low;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const double s = axis.dot(ring[i]);
    low = std::min(low, s);
    high = std::max(high, s);
  }
  return high - low;
}

/// Smallest distance between two parallel lines that hold a convex ring between them [m].
[[nodiscard]] inline double least_width(Ring ring) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 edge = ring[(i + 1) % ring.size()] - ring[i];
    double widest = 0;
    for (const Vec2& v : ring) widest = std::max(widest, cross(edge, v - ring[i]));
    least = std::min(least, widest / edge.norm());
  }
  return least;
}

/// Diameter over least width [-], >= 1.
[[nodiscard]] inline double aspect(Ring ring) { return diameter(ring) / least_width(ring); }

}  // namespace riprap
