// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A stone, convex or concave, as the convex cells that fill it. Optional: not part of riprap.hpp.

#include <vector>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/convex_parts.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/geometry/outline.hpp>
#include <riprap/geometry/polygon_properties.hpp>

namespace riprap {

/// Convex cells [m], one or more, that fill a stone and do not overlap. Where cells share a vertex
/// it has the same bits in all of them, and the motions below keep that.
struct Stone {
  std::vector<ConvexPolygon> cells;

  [[nodiscard]] double area() const {  ///< [m^2]
    double sum = 0;
    for (const ConvexPolygon& cell : cells) sum += polygon_area(cell.ring());
    return sum;
  }
  [[nodiscard]] Vec2 centroid() const {  ///< [m]
    double area = 0;
    Vec2 moment{0, 0};
    for (const ConvexPolygon& cell : cells) {
      const AreaProperties own = area_properties(cell.ring());
      area += own.area;
      // From the first vertex, so that digits survive far from the origin.
      moment += own.area * (own.centroid - cells[0][0]);
    }
    return cells[0][0] + moment / area;
  }
  /// Scaled about the origin, then turned about it and shifted [m].
  [[nodiscard]] Stone moved(double scale, const Rotation& rotation, const Vec2& shift) const {
    Stone out;
    for (const ConvexPolygon& cell : cells) {
      std::vector<Vec2> vertices;
      for (const Vec2& v : cell) vertices.push_back(scale * (rotation * v) + shift);
      out.cells.emplace_back(std::move(vertices));
    }
    return out;
  }
};

/// The stone of an outline: its convex_parts.
[[nodiscard]] inline Stone stone_of(const Outline& outline) { return {convex_parts(outline)}; }

/// The same of each.
[[nodiscard]] inline std::vector<Stone> stones_of(const std::vector<Outline>& outlines) {
  std::vector<Stone> stones;
  for (const Outline& outline : outlines) stones.push_back(stone_of(outline));
  return stones;
}

}  // namespace riprap
