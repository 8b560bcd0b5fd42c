// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/contact_law/incremental_spring.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near;
using test::near_relative;

namespace {

constexpr IncrementalSpring law{
    .normal_stiffness = 2e7, .tangential_stiffness = 1.2e7, .friction = 0.5};
using History = IncrementalSpring::History;

// Approaches by `way` [m] in equal steps; returns the work done on the contact [J].
double approach(double way, int steps, History& history) {
  double work = 0;
  for (int i = 0; i < steps; ++i) {
    const double before = history.normal_force;
    const double after = law({}, {.normal_velocity = -way / steps, .time_step = 1}, history).normal;
    work += 0.5 * (before + after) * way / steps;
  }
  return work;
}

}  // namespace

TEST_CASE("the normal force grows with the displacement and is given back") {
  History history;
  const double work = approach(5e-5, 100, history);
  CHECK(history.normal_force == near_relative(1000, 1e-13));
  CHECK(work == near_relative(0.5 * 2e7 * 25e-10, 1e-13));
  CHECK(law.stored_energy({}, history) == near_relative(work, 1e-13));
  CHECK(approach(-5e-5, 100, history) == near_relative(-work, 1e-12));
  CHECK(history.normal_force == near(0, 1e-9));
}

TEST_CASE("bodies that part further feel no tension, and load at once when they come back") {
  History history;
  approach(2e-5, 10, history);
  approach(-6e-5, 10, history);
  CHECK(history.normal_force == 0);
  approach(1e-5, 10, history);
  CHECK(history.normal_force == near_relative(200, 1e-13));
}

TEST_CASE("shear slips at the friction coefficient times the normal force") {
  History history;
  approach(5e-5, 10, history);
  const ContactForce force = law({}, {.tangential_velocity = -1, .time_step = 1}, history);
  CHECK(force.tangential == near_relative(500, 1e-13));
  CHECK(force.friction_loss > 0);
  const ContactForce again = law({}, {.normal_velocity = 3, .tangential_velocity = 2}, history);
  CHECK(again.normal == force.normal);
  CHECK(again.tangential == force.tangential);
}

TEST_CASE("an incremental spring with parameters that cannot be is refused by name") {
  CHECK(test::message_of([] { IncrementalSpring{}.validate(); }) == "");
  CHECK(test::message_of([] { IncrementalSpring{.normal_stiffness = -1}.validate(); }) ==
        "IncrementalSpring.normal_stiffness = -1: must be a finite number above 0");
  CHECK(test::message_of([] { IncrementalSpring{.friction = -1}.validate(); }) ==
        "IncrementalSpring.friction = -1: must be a finite number, 0 or above");
}
