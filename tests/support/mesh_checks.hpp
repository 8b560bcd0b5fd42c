// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What every mesh of a convex polygon must be.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <utility>

#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/stress/mesher/mesh.hpp>

namespace riprap::test {

/// Triangles have area, all of them together the polygon's.
inline void check_cover(const ConvexPolygon& polygon, const Mesh& mesh) {
  double sum = 0;
  double least = 1e300;
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    sum += mesh.area(e);
    least = std::min(least, mesh.area(e));
  }
  CHECK(least > 0);
  // Round-off of as many additions as there are triangles, and of places along the perimeter, which
  // counts for more in a splinter.
  const double area = area_properties(polygon.ring()).area;
  const double additions = static_cast<double>(mesh.size() + 20);
  CHECK(std::abs(sum - area) <=
        1e-16 * (additions * area + 4 * std::pow(diameter(polygon.ring()), 2)));
}

/// Every edge runs once along the boundary, or once each way inside.
inline void check_conforming(const Mesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::set<std::uint32_t> used;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      CHECK(edges.insert({t[k], t[(k + 1) % 3]}).second);
      used.insert(t[k]);
    }
  std::size_t one_sided = 0;
  for (const auto& [from, to] : edges) {
    if (edges.contains({to, from})) continue;
    ++one_sided;
    CHECK(from < mesh.boundary_nodes);
    CHECK(to == (from + 1) % mesh.boundary_nodes);
  }
  CHECK(one_sided == mesh.boundary_nodes);
  CHECK(used.size() == mesh.nodes.size());
  // Euler: nodes - edges + triangles = 1 for a disc; inner edges were counted twice.
  const std::size_t edge_count = (edges.size() + one_sided) / 2;
  CHECK(mesh.nodes.size() + mesh.size() == edge_count + 1);
}

/// Boundary nodes divide each edge of the polygon evenly.
inline void check_even_boundary(const ConvexPolygon& polygon, const Mesh& mesh) {
  REQUIRE(mesh.corners.size() == polygon.size());
  const double round_off = 1e-15 * diameter(polygon.ring());
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 edge = polygon[(k + 1) % polygon.size()] - polygon[k];
    const std::uint32_t end = k + 1 < polygon.size() ? mesh.corners[k + 1] : mesh.boundary_nodes;
    REQUIRE(end > mesh.corners[k]);
    const double parts = end - mesh.corners[k];
    for (std::uint32_t i = mesh.corners[k]; i < end; ++i) {
      const Vec2 place = polygon[k] + ((i - mesh.corners[k]) / parts) * edge;
      CHECK((mesh.nodes[i] - place).norm() <= round_off);
    }
  }
}

}  // namespace riprap::test
