// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/mean_diameter.hpp>

#include <doctest/doctest.h>

#include <riprap/dynamics/boundary/rigid_platens.hpp>
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/particle/random_stones.hpp>
#include <support/bonded_clusters.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

struct FirstStep {
  double mean_diameter = 0;
  bool stop_requested(const auto& view) {
    mean_diameter = view.mean_diameter;
    return true;
  }
};

}  // namespace

TEST_CASE("a cluster is one particle, broken or not") {
  auto sim = bonded_clusters();
  const double cell = cell_side * cell_side;
  // Two clusters of four cells and a cell of its own; the slab is held.
  CHECK(mean_particle_diameter(sim) == near_relative(equivalent_diameter(9 * cell / 3), 1e-12));
  CHECK(sim.mean_area() == near_relative(cell, 1e-12));
  sim.break_bonds([](const auto&) { return true; });
  CHECK(mean_particle_diameter(sim) == near_relative(equivalent_diameter(9 * cell / 3), 1e-12));
}

TEST_CASE("in a model without bonds it is that of the mean area") {
  Assembly loose = two_clusters_and_a_square();
  loose.bonds.clear();
  const Simulation sim{Model{}.boundary(NoBoundary{}), loose, Rock{}};
  CHECK(mean_particle_diameter(sim) == equivalent_diameter(sim.mean_area()));
}

TEST_CASE("a test of stones of bonded cells has the mean diameter of the stones") {
  const Outline l_shape({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}});
  RandomAssembly options{.count = 30, .seed = 1};
  options.diameters.assign(30, 0.02);
  StoneAssembly stones = random_platen_stones(options, {stone_of(l_shape)});
  for (const auto& cluster : stones.clusters()) bond_common_edges(stones.assembly, cluster);
  Simulation sim{Model{}
                     .boundary(RigidPlatens{})
                     .criterion(NeverFails{})
                     .bond_law(BrittleBond{.tensile_strength = 1e30, .cohesion = 1e30}),
                 stones.assembly, Rock{}};
  FirstStep first;
  BiaxialTest{}.run(sim, first);
  CHECK(first.mean_diameter == near_relative(0.02, 1e-12));
}
