// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/line_fit/mean_stress_line.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <support/loaded_disc.hpp>

using namespace riprap;
using namespace riprap::test;

TEST_CASE("the line runs through the centroid along the larger of two pairs of forces") {
  for (const double angle : {0.0, 0.4, 1.9}) {
    const auto disc = LoadedDisc::under(
        {{angle, 900}, {angle + pi, 900}, {angle + 0.5 * pi, 700}, {angle + 1.5 * pi, 700}});
    const auto line = ask(MeanStressLine{}, disc.moved({}, 1, {3, -2}));
    REQUIRE(line);
    // Radii of 10 mm at 3 m: 1e-16 of that.
    CHECK((line->point - Vec2{3, -2}).norm() < 1e-15);
    CHECK(std::abs(cross(line->direction, Rotation::from_angle(angle) * Vec2{1, 0})) < 1e-12);
  }
}

TEST_CASE("under equal principal stresses there is no line") {
  CHECK_FALSE(
      ask(MeanStressLine{}, LoadedDisc::under({{0, 9}, {0.5 * pi, 9}, {pi, 9}, {1.5 * pi, 9}})));
  CHECK_FALSE(ask(MeanStressLine{}, LoadedDisc::under({})));
}
