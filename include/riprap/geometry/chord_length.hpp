// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Length of the part of a straight line that lies in a convex ring.

#include <algorithm>
#include <cstddef>
#include <limits>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/cut.hpp>

namespace riprap {

/// [m]; 0 for a line that passes the ring by.
[[nodiscard]] inline double chord_length(Ring ring, const Line& line) {
  double first = std::numeric_limits<double>::infinity();
  double last = -first;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2& p = ring[k];
    const Vec2& q = ring[k + 1 == ring.size() ? 0 : k + 1];
    const double at_p = line.left_distance(p);
    const double at_q = line.left_distance(q);
    if ((at_p > 0) == (at_q > 0)) continue;
    const Vec2 crossing = p + (at_p / (at_p - at_q)) * (q - p);
    const double along = line.direction.dot(crossing - line.point);
    first = std::min(first, along);
    last = std::max(last, along);
  }
  return std::max(0.0, last - first);
}

}  // namespace riprap
