// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cstdint>

#include <riprap/stress/mesher/fan_mesher.hpp>

namespace riprap {

RIPRAP_INLINE Mesh FanMesher::operator()(Ring ring) const {
  const auto corners = static_cast<std::uint32_t>(ring.size());
  Mesh mesh;
  mesh.boundary_nodes = corners * edge_divisions;
  for (std::uint32_t k = 0; k < corners; ++k) {
    const Vec2 edge = ring[(k + 1) % corners] - ring[k];
    mesh.corners.push_back(k * edge_divisions);
    for (unsigned i = 0; i < edge_divisions; ++i)
      mesh.nodes.push_back(ring[k] + (double(i) / edge_divisions) * edge);
  }
  mesh.nodes.push_back(Vec2{0, 0});
  for (std::uint32_t i = 0; i < mesh.boundary_nodes; ++i)
    mesh.triangles.push_back({i, (i + 1) % mesh.boundary_nodes, mesh.boundary_nodes});
  return mesh;
}

RIPRAP_INLINE void FanMesher::validate() const {
  require(edge_divisions >= 1 && edge_divisions <= 1000, "FanMesher.edge_divisions", edge_divisions,
          "must lie between 1 and 1000");
}

}  // namespace riprap
