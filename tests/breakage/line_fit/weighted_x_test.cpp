// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/line_fit/weighted_x.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/breakage/line_fit/weighted_y.hpp>
#include <support/near.hpp>
#include <support/point_clouds.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

std::optional<Line> fit(const Cloud& cloud) { return WeightedX{}(cloud, FailurePlanes{}); }
// x = slope y + intercept.
double slope(const Line& line) { return line.direction.x() / line.direction.y(); }
double intercept(const Line& line) { return line.point.x() - slope(line) * line.point.y(); }

}  // namespace

TEST_CASE("the X line through three weighted points") {
  const auto line = fit(three_points());
  REQUIRE(line);
  CHECK(slope(*line) == near(0.6, 1e-14));
  CHECK(intercept(*line) == near(8.0 / 35, 1e-14));  // 0.2285714
  CHECK(line->direction.norm() == near(1, 1e-15));
}

TEST_CASE("the X line is the Y line of the cloud with x and y exchanged") {
  const auto swap = [](const Vec2& p) { return Vec2{p.y(), p.x()}; };
  const auto x_line = fit(scattered_points());
  const auto y_line = WeightedY{}(mapped(scattered_points(), swap), FailurePlanes{});
  REQUIRE(x_line);
  REQUIRE(y_line);
  CHECK(off_angle(x_line->direction, swap(y_line->direction)) == near(0, 1e-15));
  CHECK(x_line->left_distance(swap(y_line->point)) == near(0, 1e-15));
}

TEST_CASE("the X line is the Y line of the cloud turned by 90 degrees, turned back") {
  const auto x_line = fit(scattered_points());
  const auto y_line = WeightedY{}(mapped(scattered_points(), perpendicular), FailurePlanes{});
  CHECK(off_angle(perpendicular(x_line->direction), y_line->direction) == near(0, 1e-15));
}

TEST_CASE("both lines pass through the weighted centroid, the X line is the steeper one") {
  const auto x_line = fit(scattered_points());
  const auto y_line = WeightedY{}(scattered_points(), FailurePlanes{});
  CHECK(x_line->left_distance(y_line->point) == near(0, 1e-15));
  CHECK(std::abs(x_line->direction.y() / x_line->direction.x()) >
        std::abs(y_line->direction.y() / y_line->direction.x()));
}

TEST_CASE("the X line far from the origin is the shifted line") {
  const Vec2 shift{-9000, 500};
  const auto here = fit(scattered_points());
  const auto there =
      fit(mapped(scattered_points(), [&](const Vec2& p) { return Vec2(p + shift); }));
  REQUIRE(there);
  // Positions are rounded to 9000 * 1.1e-16 there.
  CHECK(off_angle(there->direction, here->direction) == near(0, 2e-11));
  CHECK(there->left_distance(here->point + shift) == near(0, 2e-11));
}

TEST_CASE("a horizontal cloud has no X line, a vertical one has") {
  CHECK_FALSE(fit({{{0, 1.7}, 1}, {{2, 1.7}, 1}, {{3, 1.7}, 4}}));
  const auto upright = fit({{{4, 0}, 1}, {{4, 1}, 2}});
  REQUIRE(upright);
  CHECK(off_angle(upright->direction, Vec2{0, 1}) == 0);
  CHECK(upright->left_distance({4, 9}) == 0);
  CHECK_FALSE(fit({{{1, 2}, 3}}));
  CHECK_FALSE(fit({}));
}
