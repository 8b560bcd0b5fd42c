// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A convex polygon as triangles that are polygons of their own. Optional: not part of riprap.hpp.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/stress/mesher/concepts.hpp>
#include <riprap/stress/mesher/uniform_mesher.hpp>

namespace riprap {

/// The triangles of a mesh of the polygon, where it stands; its vertices are among theirs. Common
/// vertices have the same bits in all of them, triangles meet along whole edges, and areas add up
/// to the polygon's to round-off.
template <Mesher M>
[[nodiscard]] std::vector<ConvexPolygon> triangle_cells(const ConvexPolygon& polygon,
                                                        const M& mesher) {
  const Vec2 centroid = area_properties(polygon.ring()).centroid;
  Mesh mesh = mesher(polygon.moved({}, -centroid).ring());
  for (Vec2& node : mesh.nodes) node += centroid;
  for (std::size_t k = 0; k < polygon.size(); ++k) mesh.nodes[mesh.corners[k]] = polygon[k];
  std::vector<ConvexPolygon> cells;
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    const auto [p, q, r] = mesh.triangle(e);
    cells.push_back(ConvexPolygon{p, q, r});
  }
  return cells;
}

/// Nearly equilateral triangles whose sides are near `side` [m]: as many as their area gives, four
/// or more. Throws InvalidInput for more than 10,000, and as UniformMesher does.
[[nodiscard]] inline std::vector<ConvexPolygon> triangle_cells(const ConvexPolygon& polygon,
                                                               double side) {
  require_positive("triangle_cells: side", side);
  const double share = polygon_area(polygon.ring()) / (0.25 * std::numbers::sqrt3 * side * side);
  require(share <= 10000, "triangle_cells: number of triangles", share, "must be at most 10,000");
  const auto count = static_cast<unsigned>(std::max(4L, std::lround(share)));
  return triangle_cells(polygon, UniformMesher{.triangles = count});
}

}  // namespace riprap
