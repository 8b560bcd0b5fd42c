// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <string>

#include <riprap/dynamics/damping/local_damping.hpp>
#include <riprap/dynamics/integrator/symplectic_euler.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

Body moving(const Vec2& velocity, double spin) {
  Body body;
  body.velocity = velocity;
  body.angular_velocity = spin;
  body.mass = 2;
  body.inertia = 0.5;
  return body;
}

std::string message_of(double coefficient) {
  try {
    LocalDamping{coefficient}.validate();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("local damping opposes the motion, component by component") {
  const LocalDamping damping{0.7};
  for (const double x : {3.0, -3.0})
    for (const double y : {5.0, -5.0})
      for (const double moment : {2.0, -2.0})
        for (const double sign : {1.0, -1.0}) {
          const Wrench added = damping(moving({0.1 * sign, -0.2}, 0.4 * sign), {{x, y}, moment});
          CHECK(added.force.x() == near_relative(-sign * 0.7 * 3, 1e-15));
          CHECK(added.force.y() == near_relative(0.7 * 5, 1e-15));
          CHECK(added.moment == near_relative(-sign * 0.7 * 2, 1e-15));
        }
}

TEST_CASE("local damping depends on the sense of the motion and not on its speed") {
  const LocalDamping damping{0.3};
  const Wrench slow = damping(moving({1e-9, -1e-9}, 1e-9), {{7, 8}, 9});
  const Wrench fast = damping(moving({1e3, -1e3}, 1e3), {{7, 8}, 9});
  CHECK(slow.force == fast.force);
  CHECK(slow.moment == fast.moment);
}

TEST_CASE("a body at rest starts undamped, and one in equilibrium is not damped") {
  const LocalDamping damping{0.7};
  const Wrench at_rest = damping(moving({0, 0}, 0), {{7, 8}, 9});
  CHECK(at_rest.force == Vec2{0, 0});
  CHECK(at_rest.moment == 0);
  const Wrench balanced = damping(moving({1, 2}, 3), {{0, 0}, 0});
  CHECK(balanced.force.norm() == 0);
  CHECK(balanced.moment == 0);
  // Each component by itself.
  CHECK(damping(moving({0, 1}, 0), {{7, 8}, 9}).force == Vec2{0, -0.7 * 8});
}

TEST_CASE("local damping removes its share of |F| |v| dt from a step") {
  const double alpha = 0.4;
  const double dt = 1e-3;
  const Wrench applied{{3, -5}, 2};
  const Body before = moving({10, 20}, -30);
  Body undamped = before;
  kick(undamped, applied, dt);
  const Wrench added = LocalDamping{alpha}(before, applied);
  Body damped = before;
  kick(damped, {applied.force + added.force, applied.moment + added.moment}, dt);
  const double removed = undamped.kinetic_energy() - damped.kinetic_energy();
  const double expected = alpha * dt * (3 * 10 + 5 * 20 + 2 * 30);
  // The velocity changes by less than 1e-3 of itself during the step.
  CHECK(removed == near_relative(expected, 1e-3));
}

TEST_CASE("a damped oscillator loses the same share of energy in every cycle, at any frequency") {
  const double alpha = 0.1;
  for (const double stiffness : {2.0, 2e4}) {
    Body body = moving({0, 0}, 0);
    body.position = {1, 0};
    const double dt = 1e-4 * std::sqrt(body.mass / stiffness);
    const LocalDamping damping{alpha};
    double previous = 0;
    do {
      previous = body.position.x();
      const Wrench spring{-stiffness * body.position, 0};
      const Wrench added = damping(body, spring);
      SymplecticEuler{}.advance(body, {spring.force + added.force, 0}, dt);
    } while (body.position.x() <= previous);
    // From one turning point at 1 to the next: driven by (1 - alpha) k up to the middle, slowed by
    // (1 + alpha) k beyond it; energies are equal there. First order in omega dt = 1e-4.
    CHECK(previous == near_relative(-std::sqrt((1 - alpha) / (1 + alpha)), 1e-4));
  }
}

TEST_CASE("a damping coefficient outside [0, 1) is refused by name") {
  CHECK(message_of(0) == "");
  CHECK(message_of(0.99) == "");
  CHECK(message_of(1) == "LocalDamping.coefficient = 1: must lie in [0, 1)");
  CHECK(message_of(-0.1) == "LocalDamping.coefficient = -0.1: must lie in [0, 1)");
  CHECK(message_of(std::numeric_limits<double>::quiet_NaN()) ==
        "LocalDamping.coefficient = nan: must lie in [0, 1)");
}
