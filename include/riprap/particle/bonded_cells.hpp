// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Particles made of bonded Voronoi cells. Optional: not part of riprap.hpp.

#include <cstddef>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/geometry/voronoi_cells.hpp>
#include <riprap/particle/assembly.hpp>
#include <riprap/particle/bond_common_edges.hpp>

namespace riprap {

/// The assembly with every free particle cut into Voronoi cells that are bonded along their common
/// edges and have its velocity and material; the others stay as they are. Cells take the place of
/// their particle, in the order of `voronoi_cells`. All particles have the same number of cells;
/// particle k has the seed `points.seed` + k. Throws InvalidInput for options that break a rule,
/// and for an assembly that has bonds already.
[[nodiscard]] inline Assembly bonded_cells(const Assembly& assembly,
                                           const VoronoiPoints& points = {}) {
  require(assembly.bonds.empty(), "bonded_cells: bonds of the assembly",
          static_cast<double>(assembly.bonds.size()), "must be none");
  points.validate();
  Assembly cut = assembly;
  cut.particles.clear();
  std::vector<std::vector<std::size_t>> clusters;
  for (std::size_t k = 0; k < assembly.particles.size(); ++k) {
    const PlacedParticle& particle = assembly.particles[k];
    if (particle.motion != Motion::free) {
      cut.particles.push_back(particle);
      continue;
    }
    VoronoiPoints own = points;
    own.seed += k;
    clusters.emplace_back();
    for (ConvexPolygon& cell : voronoi_cells(particle.polygon, own)) {
      clusters.back().push_back(cut.particles.size());
      cut.particles.push_back(particle);
      cut.particles.back().polygon = std::move(cell);
    }
  }
  for (const std::vector<std::size_t>& cells : clusters) bond_common_edges(cut, cells);
  return cut;
}

}  // namespace riprap
