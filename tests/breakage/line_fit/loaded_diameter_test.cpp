// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/line_fit/loaded_diameter.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <support/loaded_disc.hpp>

using namespace riprap;
using namespace riprap::test;

TEST_CASE("the line runs through the points of the two largest opposed forces") {
  const auto line =
      ask(LoadedDiameter{},
          LoadedDisc::under(
              {{0.4, 900}, {0.4 + 0.9 * pi, 800}, {0.4 + 0.5 * pi, 300}, {0.4 + 1.5 * pi, 300}}));
  REQUIRE(line);
  for (const double angle : {0.4, 0.4 + 0.9 * pi})
    CHECK(std::abs(line->left_distance(0.01 * (Rotation::from_angle(angle) * Vec2{1, 0}))) < 1e-16);
  CHECK(std::abs(line->direction.norm() - 1) < 1e-14);
}

TEST_CASE("without opposed forces there is no line") {
  CHECK_FALSE(ask(LoadedDiameter{}, LoadedDisc::under({{0, 900}})));
}
