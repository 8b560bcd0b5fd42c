// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Mid-side nodes for elements with six nodes.

#include <cstddef>
#include <utility>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/stress/mesher/mesh.hpp>

namespace riprap {

/// The same triangles with a node in the middle of every side, which two triangles share. Boundary
/// node i becomes 2 i, the middle of the side to the next one 2 i + 1; then come the inner nodes in
/// their order, then the inner mid-side nodes. Throws InvalidInput if two neighbouring boundary
/// nodes are not a side of a triangle: the node between them is part of none.
/// @param mesh valid, without mid-side nodes
[[nodiscard]] Mesh with_mid_side_nodes(const Mesh& mesh);

/// The mesh with the nodes of an element: as it is, or with mid-side nodes where they are missing.
/// Throws InvalidInput for a mesh that breaks a rule, or has mid-side nodes that no element uses.
template <std::size_t Nodes>
[[nodiscard]] Mesh mesh_for_element(Mesh mesh) {
  mesh.validate();
  if (Nodes == 6) return mesh.mid_sides.empty() ? with_mid_side_nodes(mesh) : std::move(mesh);
  require(mesh.mid_sides.empty(), "Mesh: triangles with mid-side nodes",
          static_cast<double>(mesh.mid_sides.size()), "must be 0 for an element with three nodes");
  return mesh;
}

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/stress/mesher/mid_side_nodes.ipp>
#endif
