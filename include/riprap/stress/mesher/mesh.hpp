// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A particle cut into triangles, and places on its boundary.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap {

/// A place on the boundary between two neighbouring boundary nodes, in linear interpolation.
struct BoundaryPoint {
  std::uint32_t node = 0;
  std::uint32_t next = 1;
  double weight = 1;  ///< of `node`; `next` has the rest
};

/// Triangles of one convex polygon, in the body's own frame (centroid at the origin).
struct Mesh {
  std::vector<Vec2> nodes;  ///< boundary nodes first, counter-clockwise from polygon vertex 0 [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< counter-clockwise
  std::vector<std::uint32_t> corners;  ///< boundary node at each vertex of the polygon
  /// Nodes in the middles of the sides 0-1, 1-2, 2-0 of each triangle; none for 3-node triangles.
  /// On the boundary corners, with even numbers, and mid-side nodes alternate. Meshers leave it
  /// empty; with_mid_side_nodes adds them.
  std::vector<std::array<std::uint32_t, 3>> mid_sides{};

  std::uint32_t boundary_nodes = 0;

  /// Throws InvalidInput that names the node or triangle, and the rule: finite nodes, each part of
  /// a triangle; counter-clockwise triangles of existing nodes that are not flat; boundary nodes
  /// and corners that exist; mid-side nodes, if any, for all triangles, in the middles.
  void validate() const;

  [[nodiscard]] std::size_t size() const { return triangles.size(); }
  /// Node k of triangle e: the corners, then the mid-side nodes.
  [[nodiscard]] std::uint32_t node(std::size_t e, std::size_t k) const {
    return k < 3 ? triangles[e][k] : mid_sides[e][k - 3];
  }
  [[nodiscard]] std::array<Vec2, 3> triangle(std::size_t e) const {
    return {nodes[triangles[e][0]], nodes[triangles[e][1]], nodes[triangles[e][2]]};
  }
  [[nodiscard]] double area(std::size_t e) const {
    const auto [p, q, r] = triangle(e);
    return 0.5 * cross(q - p, r - p);
  }
  [[nodiscard]] Vec2 centroid(std::size_t e) const {
    const auto [p, q, r] = triangle(e);
    return (p + q + r) / 3;
  }

  [[nodiscard]] Vec2 position(const BoundaryPoint& at) const {
    return at.weight * nodes[at.node] + (1 - at.weight) * nodes[at.next];
  }
};

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/stress/mesher/mesh.ipp>
#endif
