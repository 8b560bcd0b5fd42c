// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/contact_law/energy_conserving_spring.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include <riprap/core/random.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near;
using test::near_relative;

namespace {

constexpr EnergyConservingSpring law{
    .normal_stiffness = 2e7, .tangential_stiffness = 1.2e7, .friction = 0.5};
using History = EnergyConservingSpring::History;

ContactGeometry pressed(double depth, double gradient = 1) {
  ContactGeometry geometry;
  geometry.depth = depth;
  geometry.depth_gradient = gradient;
  return geometry;
}

double normal_force(const ContactGeometry& geometry, History& history) {
  return law(geometry, {.time_step = 1e-6}, history).normal;
}

}  // namespace

TEST_CASE("the normal force is stiffness times depth times its gradient") {
  History history;
  CHECK(normal_force(pressed(5e-5), history) == near_relative(1000, 1e-15));
  CHECK(normal_force(pressed(5e-5, 1.4), history) == near_relative(1400, 1e-15));
  CHECK(law.stored_energy(pressed(5e-5, 1.4), history) == near_relative(0.5 * 2e7 * 25e-10, 1e-15));
  CHECK(law.peak_stiffness() == 4e7);
}

TEST_CASE("below its offset a contact is free of force, and the offset falls with the depth") {
  History history{.offset = 3e-5};
  CHECK(normal_force(pressed(5e-5), history) == near_relative(2e7 * 2e-5, 1e-14));
  CHECK(history.offset == 3e-5);
  CHECK(law.stored_energy(pressed(5e-5), history) == near_relative(0.5 * 2e7 * 4e-10, 1e-14));
  CHECK(normal_force(pressed(2e-5), history) == 0);
  CHECK(history.offset == 2e-5);
  CHECK(law.stored_energy(pressed(2e-5), history) == 0);
  CHECK(normal_force(pressed(2.5e-5), history) == near_relative(2e7 * 0.5e-5, 1e-14));
}

TEST_CASE("a contact that one piece takes over keeps its force") {
  History history{.tangential_force = 100, .offset = 1e-5};
  const ContactGeometry before = pressed(6e-5, 1.2);
  const ContactGeometry now = pressed(7e-5, 1.3);
  const History after = law.divided_history(history, before, {now, 1});
  History copy = after;
  CHECK(normal_force(now, copy) == near_relative(2e7 * 5e-5 * 1.2, 1e-13));
  CHECK(after.tangential_force == 100);
}

TEST_CASE("pieces share the force by their overlaps, and no more energy than there was") {
  Random random(3);
  int by_force = 0;
  int by_energy = 0;
  for (int i = 0; i < 2000; ++i) {
    const History history{.tangential_force = random.uniform(-300, 300),
                          .offset = random.uniform(0, 5e-5)};
    const ContactGeometry before =
        pressed(history.offset + random.uniform(1e-5, 1e-4), random.uniform(0.5, 1.5));
    const double share = random.uniform(0, 1);
    const double old_force = 2e7 * (before.depth - history.offset) * before.depth_gradient;
    const double old_energy = law.stored_energy(before, history);
    double energy = 0;
    for (const double part : {share, 1 - share}) {
      const ContactGeometry now = pressed(random.uniform(1e-5, 1.5e-4), random.uniform(0.2, 1.5));
      History after = law.divided_history(history, before, {now, part});
      CHECK(after.offset >= 0);
      const double force = normal_force(now, after);
      CHECK(force <= part * old_force * (1 + 1e-12));
      const double stored = law.stored_energy(now, after);
      CHECK(stored <= part * old_energy * (1 + 1e-12));
      energy += stored;
      if (after.offset == 0) continue;
      ++(std::abs(force - part * old_force) <= 1e-9 * old_force ? by_force : by_energy);
    }
    CHECK(energy <= old_energy * (1 + 1e-12));
  }
  CHECK(by_force > 500);
  CHECK(by_energy > 200);
}

TEST_CASE("a piece whose contact has no gradient gets its share of the energy") {
  const ContactGeometry inside = pressed(8e-5, 0);
  const History after = law.divided_history({}, pressed(5e-5), {inside, 0.25});
  CHECK(law.stored_energy(inside, after) ==
        near_relative(0.25 * law.stored_energy(pressed(5e-5), {}), 1e-12));
  CHECK(std::isfinite(law.divided_history({}, pressed(5e-5, 0), {inside, 0.25}).offset));
}

TEST_CASE("an energy-conserving spring with parameters that cannot be is refused by name") {
  CHECK(test::message_of([] { EnergyConservingSpring{}.validate(); }) == "");
  CHECK(test::message_of([] { EnergyConservingSpring{.normal_stiffness = 0}.validate(); }) ==
        "EnergyConservingSpring.normal_stiffness = 0: must be a finite number above 0");
  CHECK(test::message_of([] { EnergyConservingSpring{.tangential_stiffness = -1}.validate(); }) ==
        "EnergyConservingSpring.tangential_stiffness = -1: must be a finite number, 0 or above");
  CHECK(test::message_of([] { EnergyConservingSpring{.friction = -1}.validate(); }) ==
        "EnergyConservingSpring.friction = -1: must be a finite number, 0 or above");
}
