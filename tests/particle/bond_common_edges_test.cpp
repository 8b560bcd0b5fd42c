// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/bond_common_edges.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cstddef>

#include <support/message_of.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using test::message_of;
using test::rectangle;

namespace {

double length(const PlacedBond& bond) { return (bond.ends[1] - bond.ends[0]).norm(); }

}  // namespace

TEST_CASE("squares of a lattice are bonded to their neighbours, and not across corners") {
  Assembly assembly;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j) assembly.particles.push_back({rectangle({1.0 * i, 1.0 * j}, 1, 1)});
  CHECK(bond_common_edges(assembly) == 3 * 3 + 4 * 2);
  CHECK(assembly.bonds.size() == 17);
  for (const PlacedBond& bond : assembly.bonds) {
    CHECK(bond.a < bond.b);
    CHECK(std::abs(length(bond) - 1) <= 1e-15);
  }
  CHECK_NOTHROW(assembly.validate());
}

TEST_CASE("edges of different lengths are bonded where they lie on each other") {
  Assembly assembly;
  assembly.particles = {{rectangle({0, 0}, 2, 1, 0.4)}};
  const Rotation turn = Rotation::from_angle(0.4);
  // On its upper edge: one beyond its end, one that meets it at a corner only, one a gap away.
  assembly.particles.push_back({rectangle(turn * Vec2{0.9, 1}, 1, 1, 0.4)});
  assembly.particles.push_back({rectangle(turn * Vec2{-1.5, 1}, 1, 1, 0.4)});
  assembly.particles.push_back({rectangle(turn * Vec2{0, -1.01}, 1, 1, 0.4)});
  REQUIRE(bond_common_edges(assembly) == 1);
  CHECK(std::abs(length(assembly.bonds[0]) - 0.6) <= 1e-14);
  for (const Vec2& end : assembly.bonds[0].ends)
    CHECK(std::abs((turn.inverse_times(end)).y() - 0.5) <= 1e-15);
}

TEST_CASE("only the particles named are bonded, and edges within the tolerance") {
  Assembly assembly;
  for (int i = 0; i < 3; ++i) assembly.particles.push_back({rectangle({1.001 * i, 0}, 1, 1)});
  const std::array<std::size_t, 2> two{2, 1};
  CHECK(bond_common_edges(assembly, two) == 0);
  REQUIRE(bond_common_edges(assembly, two, 0.01) == 1);
  CHECK(assembly.bonds[0].a == 1);
  CHECK(assembly.bonds[0].b == 2);
  // Half-way between the two edges.
  CHECK(std::abs(assembly.bonds[0].ends[0].x() - 1.5015) <= 1e-14);
}

TEST_CASE("particles are bonded across the boundary of a periodic cell") {
  Assembly assembly;
  assembly.period = {3, 2};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 2; ++j) assembly.particles.push_back({rectangle({1.0 * i, 1.0 * j}, 1, 1)});
  // Each of six squares to the right and upwards; across the upper border to the same row.
  CHECK(bond_common_edges(assembly) == 12);
  int crossing = 0;
  for (const PlacedBond& bond : assembly.bonds)
    if (bond.image != PeriodicDomain::Image{}) ++crossing;
  CHECK(crossing == 2 + 3);
  // Sheared by half a square, those of the upper border meet two each.
  assembly.bonds.clear();
  assembly.shear_offset = 0.5;
  CHECK(bond_common_edges(assembly) == 9 + 6);
  // After any number of periods of shear, images of them are those neighbours.
  for (const double offset : {0.5 + 4 * 3, 0.5 - 5 * 3}) {
    assembly.bonds.clear();
    assembly.shear_offset = offset;
    CHECK(bond_common_edges(assembly) == 9 + 6);
  }
}

TEST_CASE("bonds move with their assembly, and those that break a rule are named") {
  Assembly assembly;
  for (int i = 0; i < 2; ++i) assembly.particles.push_back({rectangle({1.0 * i, 0}, 1, 1)});
  bond_common_edges(assembly);
  const Assembly moved = assembly.moved({2, 1});
  CHECK((moved.bonds[0].ends[0] - assembly.bonds[0].ends[0] - Vec2{2, 1}).norm() <= 1e-15);

  const std::array<std::size_t, 1> beyond{2};
  CHECK(message_of([&] { bond_common_edges(assembly, beyond); }) ==
        "bond_common_edges: particle = 2: must be in the assembly");
  CHECK(message_of([&] { bond_common_edges(assembly, 0.5); }) ==
        "bond_common_edges: tolerance = 0.5: must be above 0 and below 0.1");
  const auto refused = [&](auto&& change) {
    Assembly other = assembly;
    change(other);
    return message_of([&] { other.validate(); });
  };
  CHECK(refused([](Assembly& a) { a.bonds[0].b = 5; }) ==
        "Assembly.bonds[0]: particle = 5: must be in the assembly");
  CHECK(refused([](Assembly& a) { a.bonds[0].b = 0; }) ==
        "Assembly.bonds[0]: particle = 0: must not be bonded to itself");
  CHECK(refused([](Assembly& a) { a.bonds[0].ends[1] = a.bonds[0].ends[0]; }) ==
        "Assembly.bonds[0]: length [m] = 0: must be above 0 and finite");
  CHECK(refused([](Assembly& a) { a.particles[1].motion = Motion::wall; }) ==
        "Assembly.bonds[0]: particle 1 must not be a wall");
  CHECK(refused([](Assembly& a) { a.bonds[0].image.axis_2 = 1; }) ==
        "Assembly.bonds[0]: image (0, 1): must be zero where there is no period");
}
