// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <riprap/stress/mesh/mesh.hpp>

namespace riprap {

RIPRAP_INLINE BoundaryPoint Mesh::nearest_boundary_point(const Vec2& x) const {
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

namespace internal {

[[noreturn, gnu::cold]] RIPRAP_INLINE void throw_invalid_mesh(const char* what, std::size_t number,
                                                              const char* part, double value,
                                                              const char* rule) {
  throw_invalid(std::string("Mesh: ") + what + " " + std::to_string(number) + part, value, rule);
}

}  // namespace internal

RIPRAP_INLINE void Mesh::validate() const {
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
