// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Distance of a point from a segment and from the edges of a ring.

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

}  // namespace riprap
