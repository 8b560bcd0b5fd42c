// SPDX-License-Identifier: BSL-1.0
#include <riprap/material/rocks.hpp>

#include <doctest/doctest.h>

#include <support/message_of.hpp>

using namespace riprap;
using test::message_of;

TEST_CASE("one rock is a list of one") {
  const Rocks rocks = Rock{.density = 2700};
  CHECK(rocks.size() == 1);
  CHECK(rocks.front().density == 2700);
  CHECK_NOTHROW(rocks.validate());
}

TEST_CASE("a list of rocks keeps their order") {
  const Rocks rocks{Rock{.density = 2200}, Rock{.density = 2700}};
  CHECK(rocks[1].density == 2700);
  CHECK(rocks.densities() == std::vector<double>{2200, 2700});
  CHECK(rocks.list().size() == 2);
}

TEST_CASE("an empty list and the place of a rock that breaks a rule are named") {
  CHECK(message_of([] { Rocks(std::vector<Rock>{}).validate(); }) == "Rocks: the list is empty");
  CHECK(message_of([] {
          Rocks{Rock{}, Rock{.young = 0}}.validate();
        }) == "rock 1: Rock.young = 0: must be a finite number above 0");
  CHECK(message_of([] { Rocks{Rock{.strength_factor = -1}}.validate(); }) ==
        "Rock.strength_factor = -1: must be a finite number above 0");
}
