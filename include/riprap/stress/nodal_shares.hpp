// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A force at a boundary point, spread over the nodes of its side.

#include <array>
#include <cstddef>
#include <cstdint>

#include <riprap/core/errors.hpp>
#include <riprap/stress/mesher/mesh.hpp>

namespace riprap {

/// Shape functions of the nodes of a side, which keep force and moment: linear ones of its two
/// nodes, or quadratic ones of its three.
struct NodalShares {
  std::array<std::uint32_t, 3> nodes{};  ///< `node` and `next` of the point, then the third
  std::array<double, 3> weights{};
  std::size_t count = 2;
};

/// Of a point between neighbouring boundary nodes. Throws InvalidInput for a quadratic side if
/// `at.next` is not the node after `at.node`, counter-clockwise: the third node follows from both.
/// @param quadratic whether every second boundary node is a mid-side node
[[nodiscard]] inline NodalShares nodal_shares(const BoundaryPoint& at, bool quadratic,
                                              std::uint32_t boundary_nodes) {
  if (!quadratic) return {{at.node, at.next, 0}, {at.weight, 1 - at.weight, 0}, 2};
  const std::uint32_t after = at.node + 1 == boundary_nodes ? 0 : at.node + 1;
  require(at.next == after, "BoundaryPoint.next", at.next,
          "must be the node after BoundaryPoint.node");
  const bool from_middle = at.node % 2 != 0;
  // From the corner of the side nearer to the point, in units of half the side.
  const double x = from_middle ? at.weight : 1 - at.weight;
  const double near = (1 - x) * (1 - 0.5 * x);
  const double middle = x * (2 - x);
  const double far = -0.5 * x * (1 - x);
  if (from_middle) return {{at.node, at.next, at.node - 1}, {middle, near, far}, 3};
  return {{at.node, at.next, (at.next + 1) % boundary_nodes}, {near, middle, far}, 3};
}

}  // namespace riprap
