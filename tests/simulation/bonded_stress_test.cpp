// SPDX-License-Identifier: BSL-1.0
#include <riprap/bond/interactions.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/contact/broad_phase/all_pairs.hpp>
#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/measurement/average_stress.hpp>
#include <riprap/measurement/contact_stress.hpp>
#include <riprap/particle/bond_common_edges.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

constexpr double side = 0.02;
constexpr double thickness = 0.016;

Assembly row(std::size_t cells) {
  Assembly assembly{.thickness = thickness, .particles = {}};
  for (std::size_t i = 0; i < cells; ++i)
    assembly.particles.push_back({rectangle({side * static_cast<double>(i), 0}, side, side),
                                  i == 0 ? Motion::prescribed : Motion::free});
  bond_common_edges(assembly);
  return assembly;
}

}  // namespace

TEST_CASE("a bonded cell of a bar in tension has a uniform stress") {
  const BrittleBond law{.tensile_strength = 1e30, .cohesion = 1e30};
  Simulation sim{Model{}.boundary(NoBoundary{}).bond_law(law).mesher(UniformMesher{400}), row(3),
                 Rock{}};
  sim.set_breakage(false);
  const double tension = 3e6;
  sim.set_load(2, {tension * side * thickness, 0});
  for (int n = 0; n < 4000; ++n) sim.step();
  CHECK(sim.bond_force_on(0).force.x() == near_relative(tension * side * thickness, 1e-9));
  const std::vector<Stress2> of_cells = contact_stresses(sim.interactions(), sim.particles());
  // Forces act half-way in the open joints: at arms longer by half an opening.
  const double arms = 1 + tension / (law.normal_stiffness * side);
  CHECK(of_cells[1].s11 == near_relative(-tension * arms, 1e-9));
  CHECK(of_cells[1].s22 == near(0, 1e-9 * tension));
  CHECK(average_stress(sim.interactions(), 2 * side * side, thickness).s11 ==
        near_relative(-tension * arms, 1e-9));

  // 16 forces on 14 sides of triangles stand for a traction: an error of a sixth at the edges, of
  // no resultant, so that it decays towards the middle.
  double mean = 0;
  const std::vector<SamplingPoint> points = sim.sampling_points(1);
  const ElementStress stress = sim.element_stress(1);
  REQUIRE(points.size() == 400);
  for (std::size_t e = 0; e < stress.size(); ++e) {
    mean += points[e].area * stress[e].s11 / (side * side);
    const bool inside = std::abs(points[e].position.x()) < 0.25 * side;
    CHECK(stress[e].s11 == near_relative(-tension, inside ? 0.01 : 0.16));
    CHECK(stress[e].s22 == near(0, (inside ? 0.01 : 0.16) * tension));
  }
  CHECK(mean == near_relative(-tension, 1e-9));
}

TEST_CASE("the bonds of a cell that breaks go to the pieces that hold their edges") {
  // A block between two platens breaks; on its right a cell is bonded to the whole of its side, on
  // its left two cells to the halves.
  const double h = 0.008;
  Assembly assembly{.thickness = thickness, .particles = {}};
  const auto add = [&](const Vec2& at, double width, double height, Motion motion, double speed) {
    assembly.particles.push_back({rectangle(at, width, height), motion, {0, speed}});
  };
  add({0, 0}, 2 * h, 2 * h, Motion::free, 0);
  add({0, 1.5 * h}, 2 * h, h, Motion::prescribed, -0.5);
  add({0, -1.5 * h}, 2 * h, h, Motion::prescribed, 0.5);
  add({2 * h, 0}, 2 * h, 2 * h, Motion::free, 0);
  add({-1.5 * h, 0.5 * h}, h, h, Motion::free, 0);
  add({-1.5 * h, -0.5 * h}, h, h, Motion::free, 0);
  const std::vector<std::size_t> cells{0, 3, 4, 5};
  REQUIRE(bond_common_edges(assembly, cells) == 4);
  assembly.bonds.pop_back();  // of the two on the left
  const BrittleBond law{.normal_stiffness = 1e9,
                        .tangential_stiffness = 1e9,
                        .tensile_strength = 1e30,
                        .cohesion = 1e30};
  Simulation sim{Model{}.boundary(NoBoundary{}).bond_law(law), assembly, Rock{}};
  std::size_t bonds = 0;
  while (sim.breaks().empty() && sim.steps() < 20'000) {
    bonds = sim.bonds().size();
    sim.step();
  }
  REQUIRE(sim.breaks().size() == 1);
  CHECK(sim.bond_breaks().empty());
  const BodyIndex second = static_cast<BodyIndex>(sim.particles().size() - 1);
  CHECK(sim.particles().ancestry(second).root == 0);
  double length = 0;
  for (const auto& bond : sim.bonds()) {
    length += bond.length;
    // Both copies of the edge are where they were: the piece's own side is a part of its ring.
    CHECK(bond.a < bond.b);
    for (const auto& end : bond.view.ends) CHECK(std::abs(end.opening) < 1e-4);
  }
  CHECK(length == near_relative(2 * h + 2 * h, 1e-9));
  for (const auto& pair : sim.contacts().pairs())
    for (const auto& bond : sim.bonds()) CHECK_FALSE((pair.a == bond.a && pair.b == bond.b));
  sim.set_breakage(false);
  for (int n = 0; n < 100; ++n) sim.step();
  CHECK(sim.bonds().size() >= bonds);
}

namespace {

struct CountedSearch : AllPairs {
  int* searches;
  template <class Visit>
  void visit_pairs(std::span<const Box> boxes, Visit&& visit) const {
    ++*searches;
    AllPairs::visit_pairs(boxes, visit);
  }
};

/// A block between two platens, in a model with bonds, up to the step in which it breaks; beside it
/// two bonded cells, to which the block may be bonded.
/// @return how many searches for neighbours that step needed
int searches_of_break(bool bonded_block) {
  const double h = 0.008;
  Assembly assembly{.thickness = thickness, .particles = {}};
  assembly.particles = {
      {rectangle({0, 0}, 2 * h, 2 * h)},
      {rectangle({0, 1.5 * h}, 2 * h, h), Motion::prescribed, {0, -0.5}},
      {rectangle({0, -1.5 * h}, 2 * h, h), Motion::prescribed, {0, 0.5}},
      {rectangle({2 * h, 0}, 2 * h, 2 * h)},
      {rectangle({4 * h, 0}, 2 * h, 2 * h)},
  };
  REQUIRE(bond_common_edges(assembly, bonded_block ? std::vector<std::size_t>{0, 3, 4}
                                                   : std::vector<std::size_t>{3, 4}) > 0);
  const BrittleBond law{.normal_stiffness = 1e9,
                        .tangential_stiffness = 1e9,
                        .tensile_strength = 1e30,
                        .cohesion = 1e30};
  int searches = 0;
  Simulation sim{
      Model{}.boundary(NoBoundary{}).bond_law(law).broad_phase(CountedSearch{{}, &searches}),
      assembly, Rock{}};
  int before = 0;
  while (sim.breaks().empty() && sim.steps() < 20'000) {
    before = searches;
    sim.step();
  }
  REQUIRE(!sim.breaks().empty());
  return searches - before;
}

}  // namespace

TEST_CASE("a break searches for neighbours only if the bonds of the particle are divided") {
  CHECK(searches_of_break(false) == 0);
  CHECK(searches_of_break(true) == 1);
}
