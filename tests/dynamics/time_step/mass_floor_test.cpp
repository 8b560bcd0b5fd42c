// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>
#include <limits>
#include <string>

#include <riprap/dynamics/time_step/mass_floor.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

std::string message_of(double fraction) {
  try {
    MassFloor{fraction}.validate();
  } catch (const InvalidInput& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("the time step is a share of the root of mass over stiffness") {
  CHECK(MassFloor{0.12}.time_step(25, 2e7) == near_relative(0.12 * 1.118033988749895e-3, 1e-15));
  // Four times the mass or a quarter of the stiffness: twice the step.
  const MassFloor rule{0.3};
  CHECK(rule.time_step(4, 100) == near_relative(2 * rule.time_step(1, 100), 1e-15));
  CHECK(rule.time_step(1, 25) == near_relative(2 * rule.time_step(1, 100), 1e-15));
}

TEST_CASE(
    "a piece lighter than the floor moves with the floor's mass, a heavier one with its own") {
  const MassFloor rule;
  for (const double mass : {0.001, 0.3, 0.999}) {
    CHECK(rule.mass_scaling(mass, 1) * mass == near_relative(1, 1e-15));
    CHECK(rule.mass_scaling(mass, 1) > 1);
  }
  CHECK(rule.mass_scaling(1, 1) == 1);
  CHECK(rule.mass_scaling(50, 1) == 1);
}

TEST_CASE("a share of the critical time step that is not positive is refused by name") {
  CHECK(message_of(0.5) == "");
  CHECK(message_of(0) == "MassFloor.fraction = 0: must be a finite number above 0");
  CHECK(message_of(-1) == "MassFloor.fraction = -1: must be a finite number above 0");
  CHECK(message_of(std::numeric_limits<double>::infinity()) ==
        "MassFloor.fraction = inf: must be a finite number above 0");
}
