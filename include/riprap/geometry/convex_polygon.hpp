// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A convex polygon that is known to be one.

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/geometry/polygon_properties.hpp>

namespace riprap {

/// More vertices than this are refused: the contact kernels keep their work on the stack.
inline constexpr std::size_t max_polygon_vertices = 64;

/// A strictly convex, counter-clockwise, open ring of 3 to 64 vertices [m].
/// Every object of this class is valid; the constructor throws InvalidInput naming the rule, the
/// vertex and the values otherwise.
class ConvexPolygon {
 public:
  using value_type = Vec2;
  using const_iterator = std::vector<Vec2>::const_iterator;
  using iterator = const_iterator;

  explicit ConvexPolygon(std::vector<Vec2> vertices) : vertices_(std::move(vertices)) {
    check_vertices();
    check_convex();
  }
  ConvexPolygon(std::initializer_list<Vec2> vertices)
      : ConvexPolygon(std::vector<Vec2>(vertices)) {}

  [[nodiscard]] Ring ring() const { return vertices_; }
  [[nodiscard]] std::size_t size() const { return vertices_.size(); }
  [[nodiscard]] const Vec2& operator[](std::size_t i) const { return vertices_[i]; }
  [[nodiscard]] const_iterator begin() const { return vertices_.begin(); }
  [[nodiscard]] const_iterator end() const { return vertices_.end(); }

  /// This polygon turned about the origin and then shifted.
  [[nodiscard]] ConvexPolygon moved(const Rotation& rotation, const Vec2& shift) const {
    std::vector<Vec2> out;
    out.reserve(size());
    for (const Vec2& v : vertices_) out.push_back(rotation * v + shift);
    return ConvexPolygon(std::move(out));
  }

 private:
  [[nodiscard, gnu::cold]] std::string vertex_text(std::size_t i) const {
    return "vertex " + std::to_string(i) + " at (" + to_text(vertices_[i].x()) + ", " +
           to_text(vertices_[i].y()) + ")";
  }

  [[noreturn, gnu::cold]] void throw_vertex_count() const {
    throw InvalidInput("polygon has " + std::to_string(size()) + " vertices: must be 3 to " +
                       std::to_string(max_polygon_vertices));
  }
  [[noreturn, gnu::cold]] void throw_not_finite(std::size_t i) const {
    throw InvalidInput("polygon " + vertex_text(i) + ": coordinates must be finite");
  }

  void check_vertices() const {
    if (size() < 3 || size() > max_polygon_vertices) throw_vertex_count();
    for (std::size_t i = 0; i < size(); ++i)
      if (!is_finite(vertices_[i])) throw_not_finite(i);
  }

  [[noreturn, gnu::cold]] void throw_coinciding(std::size_t i, std::size_t next) const {
    throw InvalidInput("polygon " + vertex_text(i) + " coincides with " + vertex_text(next) +
                       ": vertices must be distinct");
  }
  [[noreturn, gnu::cold]] void throw_not_left(std::size_t k, std::size_t i, double left,
                                              double tolerance) const {
    throw InvalidInput("polygon " + vertex_text(k) + " lies " + to_text(left) +
                       " m to the left of the edge from " + vertex_text(i) + ": must be above " +
                       to_text(tolerance) + " m (strictly convex, counter-clockwise)");
  }

  [[noreturn, gnu::cold]] static void throw_out_of_range(double extent) {
    throw InvalidInput("polygon has a diameter of " + to_text(extent) +
                       " m: must lie between 1e-70 and 1e70 m, for areas and moments of inertia of "
                       "others overflow or underflow");
  }

  // Every vertex lies to the left of every edge: that is convexity, orientation and a single
  // winding in one rule. The distance asked for is far below any physical feature and far above
  // round-off in coordinates up to a thousand diameters from the origin.
  void check_convex() const {
    const double extent = diameter(vertices_);
    const double tolerance = 1e-9 * extent;
    if (std::all_of(begin(), end(), [this](const Vec2& v) { return v == vertices_[0]; }))
      throw InvalidInput("polygon has no extent: all vertices coincide");
    if (extent < 1e-70 || extent > 1e70) throw_out_of_range(extent);
    // All edges first: beside an edge without length, its own ends would be blamed for a corner.
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

  std::vector<Vec2> vertices_;
};

/// The polygon, or nothing where the vertices break one of its rules.
[[nodiscard]] inline std::optional<ConvexPolygon> try_convex_polygon(std::vector<Vec2> vertices) {
  try {
    return ConvexPolygon(std::move(vertices));
  } catch (const InvalidInput&) {
    return std::nullopt;
  }
}

}  // namespace riprap
