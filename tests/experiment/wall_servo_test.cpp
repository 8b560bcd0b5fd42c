// SPDX-License-Identifier: BSL-1.0
#include <riprap/experiment/wall_servo.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <support/near.hpp>
#include <support/rectangle.hpp>
#include <support/unbreakable.hpp>

using namespace riprap;
using namespace riprap::test;

TEST_CASE("a servo presses a block with a given force, and follows another one") {
  // A block of 1 m on a floor, a lid 2e-4 m above it.
  Simulation sim{damped(springs(1e8, 0.5)),
                 of({{rectangle({0, -0.5}, 4, 1), Motion::wall},
                     {rectangle({0, 0.5}, 1, 1)},
                     {rectangle({0, 1.5 + 2e-4}, 4, 1), Motion::wall}}),
                 rock_of(2000)};
  // Two contacts in series.
  WallServo servo(2, {0, -2}, 3e3, 0.5e8, 100 * sim.time_step(), 0.05);
  for (const double force : {3e3, 1e3}) {
    servo.set_force(force);
    for (int n = 0; n < 5000; ++n) {
      servo(sim);
      sim.step();
    }
    CHECK(servo.pushes_with(sim) == near_relative(force, 1e-6));
    CHECK(sim.force_on(2).force.y() == near_relative(force, 1e-6));
    CHECK(sim.force_on(0).force.y() == near_relative(-force, 1e-6));
    CHECK(std::abs(sim.particles().body(2).velocity.y()) <= 1e-9);
  }
  CHECK(sim.particles().body(2).velocity.x() == 0);
}

TEST_CASE(
    "a servo goes on with its wall when an earlier body is removed, and says when it has gone") {
  // As above, and a body apart that comes first.
  const auto at = [](bool removes) {
    Simulation sim{damped(springs(1e8, 0.5)),
                   of({{rectangle({40, 0}, 1, 1), Motion::wall},
                       {rectangle({0, -0.5}, 4, 1), Motion::wall},
                       {rectangle({0, 0.5}, 1, 1)},
                       {rectangle({0, 1.5 + 2e-4}, 4, 1), Motion::wall}}),
                   rock_of(2000)};
    const ParticleId lid = sim.particles().ancestry(3).id;
    WallServo servo(lid, {0, -1}, 3e3, 0.5e8, 100 * sim.time_step(), 0.05);
    for (int n = 0; n < 7000; ++n) {
      if (n == 1000 && removes) sim.remove(sim.particles().ancestry(0).id);
      if (n == 2000) servo.set_force(1e3);
      servo(sim);
      sim.step();
    }
    const BodyIndex i = sim.index_of(lid);
    CHECK(i == (removes ? 2 : 3));
    CHECK(servo.pushes_with(sim) == near_relative(1e3, 1e-6));
    CHECK(sim.force_on(i).force.y() == near_relative(1e3, 1e-6));
    const double height = sim.particles().body(i).position.y();
    sim.remove(lid);
    CHECK_THROWS_WITH_AS(servo(sim),
                         "particle 3: must be in the simulation; it has broken or was removed",
                         InvalidInput);
    return height;
  };
  CHECK(at(true) == at(false));
}

TEST_CASE("a servo refuses numbers that make no sense") {
  CHECK_THROWS_AS(WallServo(0, {0, 0}, 1, 1, 1, 1), InvalidInput);
  CHECK_THROWS_AS(WallServo(0, {0, 1}, std::nan(""), 1, 1, 1), InvalidInput);
  CHECK_THROWS_WITH_AS(WallServo(0, {0, 1}, 1, 0, 1, 1),
                       "WallServo: stiffness = 0: must be a finite number above 0", InvalidInput);
  CHECK_THROWS_AS(WallServo(0, {0, 1}, 1, 1, -1, 1), InvalidInput);
  CHECK_THROWS_AS(WallServo(0, {0, 1}, 1, 1, 1, 0), InvalidInput);
}
