// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Statically determinate support of a free particle, for direct solvers.

#include <cstdint>

#include <riprap/stress/mesher/mesh.hpp>

namespace riprap {

/// Just enough constraints to hold a free particle: node `fixed` in both directions, node `guided`
/// along the axis that lies more across the line between the two. Balanced loads cause no
/// reactions, so stress is the same for every choice.
struct DeterminateSupport {
  std::uint32_t fixed = 0;
  std::uint32_t guided = 1;

  /// Two nodes far apart: the best conditioned choice.
  [[nodiscard]] static DeterminateSupport on_opposite_sides(const Mesh& mesh) {
    return {0, mesh.boundary_nodes / 2};
  }
};

}  // namespace riprap
