// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A simple polygon, convex or concave, that is known to be one.

#include <vector>

#include <riprap/core/linkage.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap {

/// A simple, counter-clockwise, open ring of three or more vertices [m] without holes. Vertices on
/// the straight line between their neighbours, to 1e-9 of the diameter, are left out.
/// Every object of this class is valid. The constructor takes a ring that turns either way and may
/// end with its first vertex. Throws InvalidInput, with the vertices or edges and the rule, for
/// fewer than three vertices, for coordinates that are not finite, for a ring without extent, and
/// for edges that cross or touch (closer than 1e-9 of the diameter), as they do where a hole is
/// joined to the ring. The cost is of the order of the square of the number of vertices.
class Outline {
 public:
  explicit Outline(std::vector<Vec2> vertices);

  [[nodiscard]] Ring ring() const { return vertices_; }

 private:
  void check_vertices() const;
  void drop_straight_vertices(double tolerance);
  void check_simple(double tolerance) const;

  std::vector<Vec2> vertices_;
};

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/geometry/outline.ipp>
#endif
