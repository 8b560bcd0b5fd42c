// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Triangles that fan out from the centroid. The file to copy for a mesher of your own.

#include <cstdint>

#include <riprap/core/errors.hpp>
#include <riprap/stress/mesh/concepts.hpp>

namespace riprap {

/// Divides each edge evenly and joins every piece to the centroid: exact in constant stress, coarse
/// and pointed inside, where all triangles meet. Quick, and the same for every size and pose.
struct FanMesher {
  unsigned edge_divisions = 8;  ///< triangles on each edge

  [[nodiscard]] Mesh operator()(Ring ring) const {
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

  void validate() const {
    require(edge_divisions >= 1 && edge_divisions <= 1000, "FanMesher.edge_divisions",
            edge_divisions, "must lie between 1 and 1000");
  }
};

static_assert(Mesher<FanMesher>);

}  // namespace riprap
