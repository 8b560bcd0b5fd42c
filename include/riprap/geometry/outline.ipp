// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include <riprap/core/errors.hpp>
#include <riprap/geometry/line_side.hpp>
#include <riprap/geometry/outline.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/geometry/ring_distance.hpp>

namespace riprap {

namespace internal {

/// Whether two segments cross, or come closer than `tolerance` [m]. Segments that do not cross are
/// nearest at an end of one of them.
[[nodiscard]] inline bool segments_meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d,
                                        double tolerance) {
  const LineSide ab(a, b);
  const LineSide cd(c, d);
  if ((ab(c) > 0) != (ab(d) > 0) && (cd(a) > 0) != (cd(b) > 0)) return true;
  return distance_to_segment(a, c, d) <= tolerance || distance_to_segment(b, c, d) <= tolerance ||
         distance_to_segment(c, a, b) <= tolerance || distance_to_segment(d, a, b) <= tolerance;
}

[[nodiscard]] inline std::string point_text(const Vec2& p) {
  return "(" + to_text(p.x()) + ", " + to_text(p.y()) + ")";
}

}  // namespace internal

RIPRAP_INLINE Outline::Outline(std::vector<Vec2> vertices) : vertices_(std::move(vertices)) {
  if (vertices_.size() > 1 && vertices_.front() == vertices_.back()) vertices_.pop_back();
  check_vertices();
  const double tolerance = 1e-9 * diameter(vertices_);
  drop_straight_vertices(tolerance);
  check_simple(tolerance);
  if (polygon_area(vertices_) < 0) std::reverse(vertices_.begin(), vertices_.end());
}

RIPRAP_INLINE void Outline::check_vertices() const {
  if (vertices_.size() < 3)
    throw InvalidInput("outline has " + std::to_string(vertices_.size()) +
                       " vertices: must be 3 or more");
  for (std::size_t i = 0; i < vertices_.size(); ++i)
    if (!is_finite(vertices_[i]))
      throw InvalidInput("outline vertex " + std::to_string(i) + " at " +
                         internal::point_text(vertices_[i]) + ": coordinates must be finite");
  if (std::all_of(vertices_.begin(), vertices_.end(),
                  [this](const Vec2& v) { return v == vertices_[0]; }))
    throw InvalidInput("outline has no extent: all vertices coincide");
}

RIPRAP_INLINE void Outline::drop_straight_vertices(double tolerance) {
  for (std::size_t i = 0; i < vertices_.size() && vertices_.size() > 2;) {
    const std::size_t n = vertices_.size();
    const Vec2& before = vertices_[previous_vertex(i, n)];
    const Vec2& after = vertices_[next_vertex(i, n)];
    if (distance_to_segment(vertices_[i], before, after) <= tolerance)
      vertices_.erase(vertices_.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
  if (vertices_.size() < 3)
    throw InvalidInput("outline lies on a line: must have an area (3 corners or more)");
}

RIPRAP_INLINE void Outline::check_simple(double tolerance) const {
  const std::size_t n = vertices_.size();
  const auto fail = [this, n](std::size_t i, std::size_t k) {
    const auto edge = [this, n](std::size_t e) {
      return internal::point_text(vertices_[e]) + " to " +
             internal::point_text(vertices_[next_vertex(e, n)]);
    };
    throw InvalidInput("outline edge from " + edge(i) + " meets the edge from " + edge(k) +
                       ": edges must not cross or touch, and an outline has no holes");
  };
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2& a = vertices_[i];
    const Vec2& b = vertices_[next_vertex(i, n)];
    const std::size_t next = next_vertex(i, n);
    // Neighbours share a corner: they must not lie on each other.
    const Vec2& c = vertices_[next_vertex(next, n)];
    if (distance_to_segment(c, a, b) <= tolerance || distance_to_segment(a, b, c) <= tolerance)
      fail(i, next);
    for (std::size_t k = i + 2; k < n; ++k) {
      if (next_vertex(k, n) == i) continue;
      if (internal::segments_meet(a, b, vertices_[k], vertices_[next_vertex(k, n)], tolerance))
        fail(i, k);
    }
  }
}

}  // namespace riprap
