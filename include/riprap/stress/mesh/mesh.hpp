// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A particle cut into 3-node triangles, and places on its boundary.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap {

/// A place on the boundary between two neighbouring boundary nodes, with linear weights.
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

  std::uint32_t boundary_nodes = 0;

  /// Throws InvalidInput that names the node or triangle, and the rule: finite nodes, each part of
  /// a triangle; counter-clockwise triangles of existing nodes that are not flat; boundary nodes
  /// and corners that exist.
  void validate() const;

  [[nodiscard]] std::size_t size() const { return triangles.size(); }
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

  /// The boundary point nearest to x (body frame).
  [[nodiscard]] BoundaryPoint nearest_boundary_point(const Vec2& x) const {
    double nearest = std::numeric_limits<double>::infinity();
    BoundaryPoint best;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const std::uint32_t first = corners[k];
      const std::uint32_t end = k + 1 < corners.size() ? corners[k + 1] : boundary_nodes;
      const Vec2& p = nodes[first];
      const Vec2 edge = nodes[end % boundary_nodes] - p;
      const double along = std::clamp(edge.dot(x - p) / edge.dot(edge), 0.0, 1.0);
      const Vec2 off = x - (p + along * edge);
      if (off.dot(off) >= nearest) continue;
      nearest = off.dot(off);
      // Nodes divide an edge evenly.
      const double place = along * (end - first);
      const auto segment = std::min(static_cast<std::uint32_t>(place), end - first - 1);
      best = {first + segment, (first + segment + 1) % boundary_nodes, 1 - (place - segment)};
    }
    return best;
  }

  [[nodiscard]] Vec2 position(const BoundaryPoint& at) const {
    return at.weight * nodes[at.node] + (1 - at.weight) * nodes[at.next];
  }
};

namespace internal {

[[noreturn, gnu::cold]] inline void throw_invalid_mesh(const char* what, std::size_t number,
                                                       const char* part, double value,
                                                       const char* rule) {
  throw_invalid(std::string("Mesh: ") + what + " " + std::to_string(number) + part, value, rule);
}

}  // namespace internal

inline void Mesh::validate() const {
  using internal::throw_invalid_mesh;
  require(!triangles.empty(), "Mesh: number of triangles", 0, "must be 1 or more");
  require(boundary_nodes <= nodes.size(), "Mesh.boundary_nodes", boundary_nodes,
          "must not be above the number of nodes");
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!is_finite(nodes[i]))
      throw_invalid_mesh("node", i, "", nodes[i].x() + nodes[i].y(), "must be finite");
  for (std::size_t k = 0; k < corners.size(); ++k)
    if (corners[k] >= boundary_nodes || (k > 0 && corners[k] <= corners[k - 1]))
      throw_invalid_mesh("corner", k, "", corners[k], "must be a boundary node, in rising order");
  std::vector<bool> used(nodes.size(), false);
  for (std::size_t e = 0; e < triangles.size(); ++e) {
    for (const std::uint32_t node : triangles[e]) {
      if (node >= nodes.size())
        throw_invalid_mesh("triangle", e, ": node", node, "must be in the mesh");
      used[node] = true;
    }
    const auto [p, q, r] = triangle(e);
    const double squared =
        std::max({(q - p).squaredNorm(), (r - q).squaredNorm(), (p - r).squaredNorm()});
    if (!(area(e) > 1e-12 * squared))
      throw_invalid_mesh("triangle", e, ": area [m^2]", area(e),
                         "must be above 0 (counter-clockwise, not flat)");
  }
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused != used.end())
    throw InvalidInput("Mesh: node " + std::to_string(unused - used.begin()) +
                       ": must be part of a triangle");
}

}  // namespace riprap
