#pragma once
/// @file
/// A contact force on the boundary of a particle's mesh.

#include <riprap/stress/mesh/mesh.hpp>

namespace riprap {

/// A point load in the body's own frame.
struct BoundaryLoad {
  BoundaryPoint at{};
  Vec2 force{0, 0};         ///< on the particle [N]
  double normal_force = 0;  ///< of the contact [N]; supports choose by it
};

}  // namespace riprap
