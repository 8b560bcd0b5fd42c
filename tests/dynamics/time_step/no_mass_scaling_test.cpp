// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>
#include <string>

#include <riprap/dynamics/time_step/mass_floor.hpp>
#include <riprap/dynamics/time_step/no_mass_scaling.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

TEST_CASE("without mass scaling the lightest piece that may come sets the time step") {
  const NoMassScaling rule{.fraction = 0.12, .lightest = 0.25};
  CHECK(rule.time_step(25, 2e7) == near_relative(0.5 * MassFloor{0.12}.time_step(25, 2e7), 1e-15));
  CHECK(rule.mass_scaling(1e-6, 1) == 1);
  CHECK(rule.mass_scaling(10, 1) == 1);
}

TEST_CASE("a lightest piece heavier than a particle, or without mass, is refused by name") {
  const auto message_of = [](const NoMassScaling& rule) -> std::string {
    try {
      rule.validate();
    } catch (const InvalidInput& error) {
      return error.what();
    }
    return "";
  };
  CHECK(message_of({}) == "");
  CHECK(message_of({.lightest = 1}) == "");
  CHECK(message_of({.lightest = 1.1}) == "NoMassScaling.lightest = 1.1: must lie in (0, 1]");
  CHECK(message_of({.lightest = 0}) == "NoMassScaling.lightest = 0: must lie in (0, 1]");
  CHECK(message_of({.fraction = 0}) ==
        "NoMassScaling.fraction = 0: must be a finite number above 0");
}
