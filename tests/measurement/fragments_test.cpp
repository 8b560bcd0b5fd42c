// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/fragments.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <riprap/measurement/breakage_indices.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <support/bonded_clusters.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

TEST_CASE("what live bonds hold together is a fragment") {
  auto sim = bonded_clusters();
  CHECK(fragment_numbers(sim) == std::vector<std::uint32_t>{0, 1, 1, 1, 1, 2, 2, 2, 2, 3});
  const std::vector<Fragment> whole = fragments(sim);
  REQUIRE(whole.size() == 4);
  CHECK_FALSE(whole[0].is_free);
  CHECK(whole[1].root == 1);
  CHECK(whole[2].root == 5);
  CHECK(whole[1].area == near_relative(4 * cell_side * cell_side, 1e-12));
  CHECK(whole[2].bodies == std::vector<BodyIndex>{5, 6, 7, 8});
  CHECK((whole[2].centroid - cell_side * Vec2{4.5, 1}).norm() <= 1e-15);

  // The lower right cell of the second cluster, then all of the first one.
  sim.break_bonds([](const auto& bond) { return bond.a == 6 || bond.b == 6; });
  sim.break_bonds([](const auto& bond) { return bond.a < 5; });
  CHECK(fragment_numbers(sim) == std::vector<std::uint32_t>{0, 1, 2, 3, 4, 5, 6, 5, 5, 7});
  const std::vector<Fragment> parts = fragments(sim);
  REQUIRE(parts.size() == 8);
  CHECK(parts[5].area == near_relative(3 * cell_side * cell_side, 1e-12));
  CHECK(parts[6].root == 5);
  for (std::size_t k = 0; k < parts.size(); ++k) CHECK(parts[k].number == k);
  int separations = 0;
  for (const BondBreak& event : sim.bond_breaks()) separations += event.separates;
  CHECK(separations == 4);  // as many as there are fragments more
}

TEST_CASE("gradings take clusters for particles, before and after") {
  auto sim = bonded_clusters();
  const double cell = cell_side * cell_side;
  const auto size = [&](double cells) { return equivalent_diameter(cells * cell); };
  const Grading before = grading_before_breakage(sim.particles());
  CHECK(before.size_at(0.1) == near_relative(size(1), 1e-12));
  CHECK(before.size_at(0.9) == near_relative(size(4), 1e-12));
  CHECK(before.passing(1.001 * size(1)) == near_relative(1.0 / 9, 1e-12));
  CHECK(fragment_grading(sim).passing(1.001 * size(1)) == near_relative(1.0 / 9, 1e-12));
  sim.break_bonds([](const auto& bond) { return bond.a < 5; });
  const Grading after = fragment_grading(sim);
  CHECK(after.passing(1.001 * size(1)) == near_relative(5.0 / 9, 1e-12));
  CHECK(grading_before_breakage(sim.particles()).passing(1.001 * size(1)) ==
        near_relative(1.0 / 9, 1e-12));
}

TEST_CASE("the grading of fragments is by mass, that of intact clusters too") {
  // Cells of the second cluster have three times the density of the others: 5 and 4 cells, 17 parts
  // of the mass.
  Assembly assembly = two_clusters_and_a_square();
  for (std::size_t i = 5; i < 9; ++i) assembly.particles[i].material = 1;
  Simulation sim{Model{}
                     .boundary(NoBoundary{})
                     .criterion(NeverFails{})
                     .bond_law(BrittleBond{.tensile_strength = 1e30, .cohesion = 1e30}),
                 assembly, Rocks{{.density = 1000}, {.density = 3000}}};
  const auto share = [](const Grading& grading, double cells) {
    return 17 * grading.passing(1.001 * equivalent_diameter(cells * cell_side * cell_side));
  };
  CHECK(share(fragment_grading(sim), 1) == near_relative(1, 1e-12));
  // One cell of the second cluster.
  sim.break_bonds([](const auto& bond) { return bond.a == 5 || bond.b == 5; });
  CHECK(share(fragment_grading(sim), 1) == near_relative(4, 1e-12));
  CHECK(share(fragment_grading(sim), 3) == near_relative(13, 1e-12));
  CHECK(share(grading_before_breakage(sim.particles()), 1) == near_relative(1, 1e-12));
}

TEST_CASE("a cluster on a slab has two contacts, its cells are no rattlers of their own") {
  auto sim = bonded_clusters();
  for (int n = 0; n < 3000; ++n) sim.step();
  // Upper cells have no contact at all; the cluster stands on two.
  const std::vector<bool> cells = rattlers(sim.contacts(), sim.particles());
  CHECK(cells[3]);
  const std::vector<bool> clusters = fragment_rattlers(sim);
  for (BodyIndex i = 1; i < 9; ++i) CHECK_FALSE(clusters[i]);
  CHECK_FALSE(clusters[0]);
  CHECK(clusters[9]);  // on one contact: it carries nothing but itself
  for (const LoadedContact& contact : loaded_fragment_contacts(sim)) CHECK(contact[0] == 0);
}

TEST_CASE("a fragment touches another once, with however many cells") {
  auto sim = bonded_clusters();
  sim.step();
  // Three free fragments, each on the slab alone, the clusters on two cells: three contacts that
  // count half.
  CHECK(fragment_coordination(sim).contacts_per_particle == 0.5);
  CHECK(fragment_coordination(sim).coordination_number == 1);
  CHECK(coordination(sim.contacts(), sim.particles()).coordination_number ==
        near_relative(5.0 / 9, 1e-15));
  // Now each upper cell of the first cluster rests on a lower one; side by side they do not
  // overlap.
  sim.break_bonds([](const auto& bond) { return bond.a < 5; });
  sim.step();
  CHECK(fragment_count(sim) == 7);
  CHECK(fragment_coordination(sim).coordination_number == near_relative((4.0 + 2 * 2) / 6, 1e-15));
  CHECK(breakages(sim) == 3);
}

TEST_CASE("in a model without bonds every body is a fragment") {
  const Simulation sim{Model{}, random_assembly({.count = 30, .seed = 2}), Rock{}};
  const std::vector<Fragment> all = fragments(sim);
  CHECK(all.size() == sim.particles().size());
  CHECK(fragment_grading(sim).size_at(0.5) == grading(sim.particles()).size_at(0.5));
}
