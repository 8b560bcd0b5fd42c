// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Distance of a point from a segment and from the edges of a ring, and the side on which it lies.

#include <algorithm>
#include <cstddef>
#include <limits>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/line_side.hpp>

namespace riprap {

/// From x to the nearest point of the segment pq [m].
[[nodiscard]] inline double distance_to_segment(const Vec2& x, const Vec2& p, const Vec2& q) {
  const Vec2 along = q - p;
  const double length = along.dot(along);
  const double share = length > 0 ? std::clamp(along.dot(x - p) / length, 0.0, 1.0) : 0.0;
  return (x - (p + share * along)).norm();
}

/// From x to the nearest point of all edges [m], inside and outside.
[[nodiscard]] inline double distance_to_ring(const Vec2& x, Ring ring) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < ring.size(); ++k)
    least = std::min(least, distance_to_segment(x, ring[k], ring[next_vertex(k, ring.size())]));
  return least;
}

/// Whether x lies inside a simple ring, concave too: a ray to the right crosses an odd number of
/// its edges. On an edge either may come out.
[[nodiscard]] inline bool ring_contains(Ring ring, const Vec2& x) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    const Vec2& p = ring[i];
    const Vec2& q = ring[j];
    if ((p.y() > x.y()) == (q.y() > x.y())) continue;
    if (x.x() < p.x() + (q.x() - p.x()) * (x.y() - p.y()) / (q.y() - p.y())) inside = !inside;
  }
  return inside;
}

}  // namespace riprap
