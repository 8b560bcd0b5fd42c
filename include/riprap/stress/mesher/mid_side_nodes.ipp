// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>

#include <riprap/stress/mesher/mid_side_nodes.hpp>

namespace riprap {

RIPRAP_INLINE Mesh with_mid_side_nodes(const Mesh& mesh) {
  const std::uint32_t boundary = mesh.boundary_nodes;
  const auto renumbered = [&](std::uint32_t i) { return i < boundary ? 2 * i : boundary + i; };
  Mesh out;
  out.boundary_nodes = 2 * boundary;
  out.nodes.assign(boundary + mesh.nodes.size(), Vec2{0, 0});
  for (std::uint32_t i = 0; i < mesh.nodes.size(); ++i) out.nodes[renumbered(i)] = mesh.nodes[i];
  for (const std::uint32_t corner : mesh.corners) out.corners.push_back(renumbered(corner));
  for (const auto& [p, q, r] : mesh.triangles)
    out.triangles.push_back({renumbered(p), renumbered(q), renumbered(r)});

  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> inner;
  for (const auto& triangle : mesh.triangles) {
    std::array<std::uint32_t, 3> middles{};
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t p = triangle[k];
      const std::uint32_t q = triangle[(k + 1) % 3];
      const Vec2 middle = 0.5 * (mesh.nodes[p] + mesh.nodes[q]);
      if (p < boundary && q == (p + 1) % boundary) {
        middles[k] = 2 * p + 1;
        out.nodes[middles[k]] = middle;
        continue;
      }
      const auto next = static_cast<std::uint32_t>(out.nodes.size());
      const auto [side, is_new] = inner.try_emplace(std::minmax(p, q), next);
      if (is_new) out.nodes.push_back(middle);
      middles[k] = side->second;
    }
    out.mid_sides.push_back(middles);
  }
  out.validate();  // every boundary node has a side
  return out;
}

}  // namespace riprap
