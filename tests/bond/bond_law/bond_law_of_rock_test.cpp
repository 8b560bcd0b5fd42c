// SPDX-License-Identifier: BSL-1.0
#include <riprap/bond/bond_law/bond_law_of_rock.hpp>

#include <doctest/doctest.h>

#include <vector>

#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/bond/bond_law/softening_bond.hpp>
#include <riprap/particle/bond_common_edges.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>
#include <support/unbreakable.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

constexpr double side = 0.1;  // [m]; the thickness is 1 m
constexpr double area = side;

/// Squares in a row of materials 0, 0, 1, 1; the ends move apart with a speed [m/s].
Assembly row(double speed) {
  Assembly assembly = of({});
  for (std::size_t i = 0; i < 4; ++i) {
    const bool end = i == 0 || i == 3;
    assembly.particles.push_back({rectangle({side * static_cast<double>(i), 0}, side, side),
                                  end ? Motion::prescribed : Motion::free,
                                  {i == 3 ? speed : 0, 0}});
    assembly.particles.back().material = i < 2 ? 0 : 1;
  }
  bond_common_edges(assembly);
  return assembly;
}

BrittleBond bond(double stiffness, double strength) {
  return {.normal_stiffness = stiffness,
          .tangential_stiffness = stiffness,
          .tensile_strength = strength,
          .cohesion = 10 * strength};
}

const Rocks rocks{Rock{}, Rock{.density = 3000}};

auto pulled(const BondLawOfRock<BrittleBond>& law, double speed) {
  return Simulation{damped(springs(1e7, 0.5)).bond_law(law), row(speed), rocks};
}

}  // namespace

TEST_CASE("the weakest of the laws of a row breaks first") {
  const std::vector<std::vector<double>> strengths{
      {1e6, 2e6, 3e6}, {2e6, 1e6, 3e6}, {3e6, 2e6, 1e6}};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::vector<double>& s = strengths[k];
    auto sim =
        pulled({.laws = {bond(2e11, s[0]), bond(2e11, s[1])}, .between = bond(2e11, s[2])}, 1e-4);
    while (sim.bond_breaks().empty() && sim.steps() < 100000) sim.step();
    REQUIRE(sim.bond_breaks().size() == 1);
    const ParticleId first = k == 0 ? 0 : k == 1 ? 2 : 1;
    CHECK(sim.bond_breaks()[0].particles[0] == first);
    CHECK(sim.bond_breaks()[0].particles[1] == first + 1);
  }
}

TEST_CASE("each bond has the stiffness of its law") {
  auto sim =
      pulled({.laws = {bond(1e11, 1e30), bond(4e11, 1e30)}, .between = bond(2e11, 1e30)}, 1e-3);
  while (sim.time() < 0.01) sim.step();
  sim.set_velocity(3, {0, 0}, 0);
  for (int i = 0; i < 20000; ++i) sim.step();
  const double length = sim.particles().body(3).position.x() - 3 * side;
  const double force = area * length / (1 / 1e11 + 1 / 2e11 + 1 / 4e11);  // springs in series
  for (const auto& one : sim.bonds()) CHECK(one.force_on_b().x() == near(-force, 1e-6 * force));
  CHECK(sim.bonds().stored_energy(1) == near(0.5 * force * length, 1e-6 * force * length));
}

TEST_CASE("bonds hold where breakage is off") {
  auto sim = pulled({.laws = {bond(2e11, 1e6), bond(2e11, 1e6)}, .between = bond(2e11, 1e6)}, 1e-3);
  sim.set_breakage(false);
  while (sim.time() < 0.1) sim.step();  // to 33 times the opening at the strength
  sim.set_velocity(3, {0, 0}, 0);
  for (int i = 0; i < 20000; ++i) sim.step();
  CHECK(sim.bonds().size() == 3);
  const double opening = (sim.particles().body(3).position.x() - 3 * side) / 3;
  REQUIRE(2e11 * opening > 6e6);
  CHECK(sim.bonds()[0].force_on_b().x() == near(-area * 2e11 * opening, 1e-6 * 2e11 * opening));
  sim.set_breakage(true);
  sim.step();
  CHECK(sim.bonds().empty());
}

TEST_CASE("damage does not grow where breakage is off") {
  Simulation sim{damped(springs(1e7, 0.5)).bond_law(SofteningBond{}), row(1e-3), rocks};
  sim.set_breakage(false);
  while (sim.time() < 0.3) sim.step();
  for (const auto& one : sim.bonds())
    for (const auto& state : one.view.states) CHECK(state.damage == 0);
  CHECK(sim.bonds().loss() == 0);
  sim.set_breakage(true);
  sim.step();
  CHECK(sim.bonds().loss() > 0);
}

TEST_CASE("a law for each rock, and the place of one that breaks a rule") {
  const BrittleBond law{};
  CHECK(contains(message_of([&] { (void)pulled({.laws = {law}}, 0); }),
                 "bond law: number of materials = 1: must be that of the rocks, 2"));
  CHECK(contains(message_of([&] {
                   (void)pulled({.laws = {law, bond(0, 1)}}, 0);
                 }),
                 "bond law of material 1: BrittleBond.normal_stiffness = 0"));
  CHECK(contains(message_of([&] {
                   (void)pulled({.laws = {law, law}, .between = bond(0, 1)}, 0);
                 }),
                 "bond law between two materials: BrittleBond.normal_stiffness = 0"));
}
