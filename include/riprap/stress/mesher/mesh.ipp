// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <riprap/stress/mesher/mesh.hpp>

namespace riprap {

namespace internal {

[[noreturn, gnu::cold]] RIPRAP_INLINE void throw_invalid_mesh(const char* what, std::size_t number,
                                                              const char* part, double value,
                                                              const char* rule) {
  throw_invalid(std::string("Mesh: ") + what + " " + std::to_string(number) + part, value, rule);
}

// In the middles of the sides, to round-off; on the boundary between corners with even numbers.
RIPRAP_INLINE void require_mid_sides(const Mesh& mesh) {
  if (mesh.mid_sides.empty()) return;
  require(mesh.mid_sides.size() == mesh.size(), "Mesh: triangles with mid-side nodes",
          static_cast<double>(mesh.mid_sides.size()), "must be none or all");
  for (std::size_t e = 0; e < mesh.size(); ++e)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t node = mesh.mid_sides[e][k];
      const std::uint32_t first = mesh.triangles[e][k];
      if (node >= mesh.nodes.size())
        throw_invalid_mesh("triangle", e, ": mid-side node", node, "must be in the mesh");
      const Vec2& p = mesh.nodes[first];
      const Vec2& q = mesh.nodes[mesh.triangles[e][(k + 1) % 3]];
      if (!((mesh.nodes[node] - 0.5 * (p + q)).norm() <= 1e-9 * (q - p).norm()))
        throw_invalid_mesh("triangle", e, ": mid-side node", node, "must be in the middle");
      const bool corner = first < mesh.boundary_nodes;
      const bool middle = node < mesh.boundary_nodes;
      if ((corner && first % 2 != 0) || (middle && (!corner || node != first + 1)))
        throw_invalid_mesh("triangle", e, ": mid-side node", node,
                           "must follow its corner, of even number, on the boundary");
    }
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
  internal::require_mid_sides(*this);
  for (const auto& sides : mid_sides)
    for (const std::uint32_t node : sides) used[node] = true;
  const auto unused = std::find(used.begin(), used.end(), false);
  if (unused != used.end())
    throw InvalidInput("Mesh: node " + std::to_string(unused - used.begin()) +
                       ": must be part of a triangle");
}

}  // namespace riprap
