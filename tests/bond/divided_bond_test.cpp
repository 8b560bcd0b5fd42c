// SPDX-License-Identifier: BSL-1.0
#include <riprap/bond/divided_bond.hpp>

#include <doctest/doctest.h>

#include <vector>

#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/bond/bond_law/softening_bond.hpp>
#include <riprap/bond/bond_list.hpp>
#include <riprap/geometry/cut.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using test::near_relative;
using test::rectangle;

namespace {

constexpr double thickness = 0.5;
using List = BondList<BrittleBond, UnboundedDomain>;

/// Square 0, bonded on its right to square 1 and on its upper side to square 2; both have moved.
struct Three {
  Particles particles{thickness, 2000};
  List list{BrittleBond{.tensile_strength = 1e30, .cohesion = 1e30}};
  std::vector<List::BondType> lost{};

  Three() {
    particles.add(rectangle({0, 0}, 1, 1), Motion::free);
    particles.add(rectangle({1, 0}, 1, 1), Motion::free);
    particles.add(rectangle({0, 1}, 1, 1), Motion::free);
    const std::vector<PlacedBond> bonds{{.a = 0, .b = 1, .ends = {{{0.5, -0.5}, {0.5, 0.5}}}},
                                        {.a = 0, .b = 2, .ends = {{{-0.5, 0.5}, {0.5, 0.5}}}}};
    list.add(bonds, particles, {});
    particles.body(0).rotation = Rotation::from_angle(0.02);
    particles.body(1).position += Vec2{1e-4, 2e-4};
    particles.body(1).rotation = Rotation::from_angle(0.01);
    particles.body(2).position += Vec2{3e-4, -2e-4};
    for (BodyIndex i = 0; i < 3; ++i) particles.update_ring(i);
    list.update(particles, {}, lost);
  }
  /// Cuts square 0 along a line; its left piece stays at 0, unless it is dust.
  DividedBody cut_first(const Line& line, bool left_is_dust = false) {
    const Body whole = particles.body(0);
    const Ancestry ancestry = particles.ancestry(0);
    const auto rings = cut(particles.ring(0), line);
    REQUIRE(rings.has_value());
    if (left_is_dust) {
      particles.replace(0, ConvexPolygon{rings->right}, Motion::free, ancestry);
      return {whole, 0, line, {std::nullopt, BodyIndex{0}}};
    }
    particles.replace(0, ConvexPolygon{rings->left}, Motion::free, ancestry);
    const BodyIndex second = particles.add(ConvexPolygon{rings->right}, Motion::free, &ancestry);
    return {whole, 0, line, {BodyIndex{0}, second}};
  }
};

}  // namespace

TEST_CASE("an edge that the crack crosses is divided; force, moment and energy stay") {
  Three three;
  const double energy = three.list.stored_energy(thickness);
  const Wrench on_1 = three.list.wrenches()[1];
  const Wrench on_2 = three.list.wrenches()[2];

  // Along axis 1 through the middle: the bond with 1 is divided, that with 2 is the left piece's.
  const DividedBody broken = three.cut_first({{0, 0.1}, {1, 0}});
  three.list.divide(broken, three.particles, {}, three.lost);
  CHECK(three.lost.empty());
  REQUIRE(three.list.size() == 3);
  CHECK(three.list[0].a == 0);
  CHECK(three.list[0].b == 1);
  CHECK(three.list[1].b == 2);
  CHECK(three.list[2].a == 1);
  CHECK(three.list[2].b == 3);
  CHECK(three.list[0].length + three.list[2].length == near_relative(1, 1e-12));
  CHECK(three.list[0].length == near_relative(0.4, 0.03));  // the square is turned by 0.02
  // What is linear along the edge is exact in each part; axes are the bodies', which have not
  // turned.
  CHECK(three.list.stored_energy(thickness) == near_relative(energy, 1e-10));
  CHECK((three.list.wrenches()[1].force - on_1.force).norm() <= 1e-9 * on_1.force.norm());
  CHECK(three.list.wrenches()[1].moment == near_relative(on_1.moment, 1e-8));
  CHECK((three.list.wrenches()[2].force - on_2.force).norm() <= 1e-9 * on_2.force.norm());
  CHECK(three.list.wrenches()[2].moment == near_relative(on_2.moment, 1e-8));
}

TEST_CASE("bonds of a piece that is dust are lost, with their part of an edge") {
  Three three;
  const double energy = three.list.stored_energy(thickness);
  const DividedBody broken = three.cut_first({{0, 0.1}, {1, 0}}, true);
  three.list.divide(broken, three.particles, {}, three.lost);
  REQUIRE(three.list.size() == 1);
  CHECK(three.list[0].b == 1);
  CHECK(three.list[0].length == near_relative(0.6, 0.03));
  CHECK(three.lost.size() == 2);
  // What is lost and what is left had the whole energy.
  double of_all = three.list.stored_energy(thickness);
  for (const auto& bond : three.lost) of_all += stored_energy(bond, three.list.law(), thickness);
  CHECK(of_all == near_relative(energy, 1e-10));
  // The part above 0.09 is lost, with its middle at 0.295: half-way between the copies that have
  // turned by 0.02 and 0.01 about points 0.5 to the left and right.
  const auto& upper = three.lost[0];
  CHECK(upper.length == near_relative(0.4, 0.03));
  CHECK((upper.middle(broken.whole) - Vec2{0.5 - 0.015 * 0.295, 0.295 + 0.0025}).norm() <= 5e-4);
  // Nothing of it any more.
  DividedBody other = broken;
  other.parent = 7;
  three.list.divide(other, three.particles, {}, three.lost);
  CHECK(three.lost.size() == 2);
  CHECK(three.list.size() == 1);
}

TEST_CASE("damage that begins at the integration points of a part is booked") {
  // Opened at its upper end, above the strength there, below it at both integration points.
  const SofteningBond law{.normal_stiffness = 1e10,
                          .tangential_stiffness = 1e10,
                          .tensile_strength = 1e6,
                          .shear_strength = 1e7,
                          .fracture_energy = 1e4};
  BondList<SofteningBond, UnboundedDomain> list{law};
  Particles particles{thickness, 2000};
  particles.add(rectangle({0, 0}, 1, 1), Motion::free);
  particles.add(rectangle({1, 0}, 1, 1), Motion::free);
  list.add(std::vector<PlacedBond>{{.a = 0, .b = 1, .ends = {{{0.5, -0.5}, {0.5, 0.5}}}}},
           particles, {});
  particles.body(1).rotation = Rotation::from_angle(-2.4e-4);
  particles.update_ring(1);
  std::vector<BondList<SofteningBond, UnboundedDomain>::BondType> lost;
  list.update(particles, {}, lost);
  CHECK(list.loss() == 0);
  const Body whole = particles.body(0);
  const Ancestry ancestry = particles.ancestry(0);
  const Line line{{0, 0.2}, {1, 0}};
  const auto rings = cut(particles.ring(0), line);
  REQUIRE(rings.has_value());
  particles.replace(0, ConvexPolygon{rings->left}, Motion::free, ancestry);
  const BodyIndex second = particles.add(ConvexPolygon{rings->right}, Motion::free, &ancestry);
  list.divide({whole, 0, line, {BodyIndex{0}, second}}, particles, {}, lost);
  REQUIRE(list.size() == 2);
  double expected = 0;
  for (const auto& bond : list)
    for (const BondDisplacement& at : bond.view.points) {
      SofteningBond::State intact;
      expected += 0.5 * bond.length * thickness * law(at, intact).loss;
    }
  CHECK(expected > 0);
  CHECK(list.loss() == near_relative(expected, 1e-12));
}
