// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Clusters of bonded squares.

#include <vector>

#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/particle/bond_common_edges.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/rectangle.hpp>

namespace riprap::test {

inline constexpr double cell_side = 0.01;

/// A held slab 0, on it two clusters of 2 x 2 squares, bodies 1 to 4 and 5 to 8, and a square 9.
[[nodiscard]] inline Assembly two_clusters_and_a_square() {
  const double s = cell_side;
  Assembly assembly{.thickness = 0.016, .particles = {}};
  assembly.particles.push_back({rectangle({5 * s, -s}, 20 * s, 2 * s), Motion::prescribed});
  for (const double left : {0.0, 4 * s}) {
    std::vector<std::size_t> cells;
    for (int k = 0; k < 4; ++k) {
      cells.push_back(assembly.particles.size());
      assembly.particles.push_back({rectangle({left + s * (k % 2), s * (0.5 + k / 2)}, s, s)});
    }
    bond_common_edges(assembly, cells);
  }
  assembly.particles.push_back({rectangle({9 * s, 0.5 * s}, s, s)});
  return assembly;
}

/// That assembly under gravity, not yet moved.
[[nodiscard]] inline auto bonded_clusters() {
  Simulation sim{Model{}
                     .boundary(NoBoundary{})
                     .criterion(NeverFails{})
                     .bond_law(BrittleBond{.tensile_strength = 1e30, .cohesion = 1e30}),
                 two_clusters_and_a_square(), Rock{}};
  sim.set_body_force({0, -9.81});
  return sim;
}

}  // namespace riprap::test
