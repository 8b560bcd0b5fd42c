// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>

#include <riprap/geometry/convex_polygon.hpp>

namespace riprap {

RIPRAP_INLINE ConvexPolygon ConvexPolygon::moved(const Rotation& rotation,
                                                 const Vec2& shift) const {
  std::vector<Vec2> out;
  out.reserve(size());
  for (const Vec2& v : vertices_) out.push_back(rotation * v + shift);
  return ConvexPolygon(std::move(out));
}

RIPRAP_INLINE std::string ConvexPolygon::vertex_text(std::size_t i) const {
  return "vertex " + std::to_string(i) + " at (" + to_text(vertices_[i].x()) + ", " +
         to_text(vertices_[i].y()) + ")";
}

RIPRAP_INLINE void ConvexPolygon::throw_vertex_count() const {
  throw InvalidInput("polygon has " + std::to_string(size()) + " vertices: must be 3 to " +
                     std::to_string(max_polygon_vertices));
}

RIPRAP_INLINE void ConvexPolygon::throw_not_finite(std::size_t i) const {
  throw InvalidInput("polygon " + vertex_text(i) + ": coordinates must be finite");
}

RIPRAP_INLINE void ConvexPolygon::check_vertices() const {
  if (size() < 3 || size() > max_polygon_vertices) throw_vertex_count();
  for (std::size_t i = 0; i < size(); ++i)
    if (!is_finite(vertices_[i])) throw_not_finite(i);
}

RIPRAP_INLINE void ConvexPolygon::throw_coinciding(std::size_t i, std::size_t next) const {
  throw InvalidInput("polygon " + vertex_text(i) + " coincides with " + vertex_text(next) +
                     ": vertices must be distinct");
}

RIPRAP_INLINE void ConvexPolygon::throw_not_left(std::size_t k, std::size_t i, double left,
                                                 double tolerance) const {
  throw InvalidInput("polygon " + vertex_text(k) + " lies " + to_text(left) +
                     " m to the left of the edge from " + vertex_text(i) + ": must be above " +
                     to_text(tolerance) + " m (strictly convex, counter-clockwise)");
}

RIPRAP_INLINE void ConvexPolygon::throw_out_of_range(double extent) {
  throw InvalidInput("polygon has a diameter of " + to_text(extent) +
                     " m: must lie between 1e-70 and 1e70 m, for areas and moments of inertia of "
                     "others overflow or underflow");
}

RIPRAP_INLINE void ConvexPolygon::check_convex() const {
  const double extent = diameter(vertices_);
  const double tolerance = 1e-9 * extent;
  if (std::all_of(begin(), end(), [this](const Vec2& v) { return v == vertices_[0]; }))
    throw InvalidInput("polygon has no extent: all vertices coincide");
  if (extent < 1e-70 || extent > 1e70) throw_out_of_range(extent);
  // Edge lengths first: an edge of zero length would be reported as a non-convex corner.
  for (std::size_t i = 0; i < size(); ++i) {
    const std::size_t next = (i + 1) % size();
    if ((vertices_[next] - vertices_[i]).norm() <= tolerance) throw_coinciding(i, next);
  }
  for (std::size_t i = 0; i < size(); ++i) {
    const std::size_t next = (i + 1) % size();
    const Vec2 edge = vertices_[next] - vertices_[i];
    const double length = edge.norm();
    for (std::size_t k = 0; k < size(); ++k) {
      if (k == i || k == next) continue;
      const double left = cross(edge, vertices_[k] - vertices_[i]) / length;
      if (left <= tolerance) throw_not_left(k, i, left, tolerance);
    }
  }
}

RIPRAP_INLINE std::optional<ConvexPolygon> try_convex_polygon(std::vector<Vec2> vertices) {
  try {
    return ConvexPolygon(std::move(vertices));
  } catch (const InvalidInput&) {
    return std::nullopt;
  }
}

}  // namespace riprap
