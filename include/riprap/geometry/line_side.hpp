// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// On which side of the lines through a convex ring's edges a point lies.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <riprap/core/vec2.hpp>

namespace riprap {

/// Of n vertices in a ring, the one after k and the one before it.
[[nodiscard]] inline std::size_t next_vertex(std::size_t k, std::size_t n) {
  return k + 1 == n ? 0 : k + 1;
}
[[nodiscard]] inline std::size_t previous_vertex(std::size_t k, std::size_t n) {
  return k == 0 ? n - 1 : k - 1;
}

/// The line from p to q. In scalars: on pairs of numbers a compiler spends more on packing them
/// than it saves.
struct LineSide {
  LineSide(const Vec2& p, const Vec2& q)
      : x(q.x() - p.x()), y(q.y() - p.y()), from_x(p.x()), from_y(p.y()) {}

  /// Distance of v to the left of the line, times the length of pq [m^2].
  [[nodiscard]] double operator()(const Vec2& v) const {
    return x * (v.y() - from_y) - y * (v.x() - from_x);
  }
  /// Of v from p along the line, times the length of pq [m^2].
  [[nodiscard]] double along(const Vec2& v) const {
    return x * (v.x() - from_x) + y * (v.y() - from_y);
  }
  /// The length of pq, up to a factor of root two too much.
  [[nodiscard]] double length_bound() const { return std::abs(x) + std::abs(y); }

  /// Does v lie to the left by `margin` [m], or a little more?
  [[nodiscard]] bool lies_left_by(const Vec2& v, double margin) const {
    return (*this)(v) > margin * length_bound();
  }

  double x, y;            ///< from p to q [m]
  double from_x, from_y;  ///< p [m]
};

/// Does v, inside edge `i` of a convex ring, lie inside all other edges as well, by a clear margin
/// [m]?
[[nodiscard]] inline bool inside_other_edges(Ring ring, std::size_t i, const Vec2& v,
                                             double margin) {
  const std::size_t n = ring.size();
  for (std::size_t j = 0; j < n; ++j)
    if (j != i && !LineSide(ring[j], ring[next_vertex(j, n)]).lies_left_by(v, margin)) return false;
  return true;
}

}  // namespace riprap
