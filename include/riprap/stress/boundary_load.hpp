// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A contact force on the boundary of a particle's mesh.

#include <riprap/core/errors.hpp>
#include <riprap/stress/mesher/mesh.hpp>

namespace riprap {

/// A point load in the body's own frame.
struct BoundaryLoad {
  BoundaryPoint at{};
  Vec2 force_body{0, 0};    ///< on the particle [N]
  double normal_force = 0;  ///< of the contact [N]; supports choose by it
};

namespace internal {

[[noreturn, gnu::cold, gnu::noinline]] inline void
throw_invalid_load(const BoundaryPoint& at, const Vec2& force, std::uint32_t boundary_nodes) {
  for (const std::uint32_t node : {at.node, at.next})
    require(node < boundary_nodes, "BoundaryPoint: node", node, "must be a boundary node");
  require(at.weight >= 0 && at.weight <= 1, "BoundaryPoint.weight", at.weight,
          "must lie in [0, 1]");
  throw InvalidInput("force of a boundary load (" + to_text(force.x()) + ", " + to_text(force.y()) +
                     ") N: must be finite");
}

}  // namespace internal

/// Throws InvalidInput unless the point lies on a boundary of so many nodes and the force is
/// finite.
inline void require_boundary_load(const BoundaryPoint& at, const Vec2& force,
                                  std::uint32_t boundary_nodes) {
  const bool valid = at.node < boundary_nodes && at.next < boundary_nodes && at.weight >= 0 &&
                     at.weight <= 1 && std::isfinite(force.x() + force.y());
  if (!valid) internal::throw_invalid_load(at, force, boundary_nodes);
}

}  // namespace riprap
