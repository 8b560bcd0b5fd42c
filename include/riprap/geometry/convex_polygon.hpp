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
#include <riprap/core/linkage.hpp>
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
  [[nodiscard]] ConvexPolygon moved(const Rotation& rotation, const Vec2& shift) const;

 private:
  [[nodiscard, gnu::cold]] std::string vertex_text(std::size_t i) const;

  [[noreturn, gnu::cold]] void throw_vertex_count() const;
  [[noreturn, gnu::cold]] void throw_not_finite(std::size_t i) const;

  void check_vertices() const;

  [[noreturn, gnu::cold]] void throw_coinciding(std::size_t i, std::size_t next) const;
  [[noreturn, gnu::cold]] void throw_not_left(std::size_t k, std::size_t i, double left,
                                              double tolerance) const;

  [[noreturn, gnu::cold]] static void throw_out_of_range(double extent);

  // Every vertex lies to the left of every edge: that is convexity, orientation and a single
  // winding in one rule. The distance asked for is far below any physical feature and far above
  // round-off in coordinates up to a thousand diameters from the origin.
  void check_convex() const;

  std::vector<Vec2> vertices_;
};

/// The polygon, or nothing where the vertices break one of its rules.
[[nodiscard]] std::optional<ConvexPolygon> try_convex_polygon(std::vector<Vec2> vertices);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/geometry/convex_polygon.ipp>
#endif
