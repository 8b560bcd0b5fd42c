// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/line_fit/weighted_xy.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <support/near.hpp>
#include <support/point_clouds.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

FailurePlanes one_plane(const Vec2& direction) {
  FailurePlanes planes;
  planes.directions[0] = direction;
  planes.count = 1;
  return planes;
}

FailurePlanes two_planes(const Vec2& p, const Vec2& q) {
  FailurePlanes planes;
  planes.directions = {p, q};
  planes.count = 2;
  return planes;
}

const Vec2 x_direction = Vec2{0.6, 1}.normalized();  // of three_points()
const Vec2 y_direction = Vec2{13, 21}.normalized();

}  // namespace

TEST_CASE("of the X and the Y line the one closer to a failure plane is taken") {
  const Cloud cloud = three_points();
  const auto at_x = WeightedXY{}(cloud, one_plane(x_direction));
  const auto at_y = WeightedXY{}(cloud, one_plane(y_direction));
  REQUIRE(at_x);
  REQUIRE(at_y);
  CHECK(off_angle(at_x->direction, x_direction) == near(0, 1e-15));
  CHECK(off_angle(at_y->direction, y_direction) == near(0, 1e-15));
  // Directions of planes have no sense.
  CHECK(WeightedXY{}(cloud, one_plane(-x_direction))->direction == at_x->direction);
  // The X line is the steeper one: an upright crack chooses it, a level one does not.
  CHECK(WeightedXY{}(cloud, one_plane({0, 1}))->direction == at_x->direction);
  CHECK(WeightedXY{}(cloud, one_plane({1, 0}))->direction == at_y->direction);
}

TEST_CASE("the closest of both failure planes counts") {
  const Cloud cloud = three_points();
  const Vec2 far{1, 0};  // alone it would choose Y
  for (const FailurePlanes& planes : {two_planes(far, x_direction), two_planes(x_direction, far)})
    CHECK(off_angle(WeightedXY{}(cloud, planes)->direction, x_direction) == near(0, 1e-15));
}

TEST_CASE("where both lines are equally close the Y line is taken") {
  // Symmetric about the diagonal, along which the failure plane runs.
  const Cloud cloud{{{0, 0}, 1}, {{4, 4}, 1}, {{1, 3}, 1}, {{3, 1}, 1}};
  const double s = std::sqrt(0.5);
  const auto line = WeightedXY{}(cloud, one_plane({s, s}));
  REQUIRE(line);
  CHECK(line->direction == WeightedY{}(cloud, {})->direction);
  CHECK(off_angle(line->direction, WeightedX{}(cloud, {})->direction) > 0.1);
  CHECK(WeightedXY{}(three_points(), FailurePlanes{})->direction ==
        WeightedY{}(three_points(), {})->direction);
}

TEST_CASE("where one of the two lines does not exist the other is taken") {
  const Cloud vertical{{{2, 0}, 1}, {{2, 1}, 1}};
  const Cloud horizontal{{{0, 2}, 1}, {{1, 2}, 1}};
  for (const Vec2& plane : {Vec2{1, 0}, Vec2{0, 1}}) {
    CHECK(off_angle(WeightedXY{}(vertical, one_plane(plane))->direction, {0, 1}) == 0);
    CHECK(off_angle(WeightedXY{}(horizontal, one_plane(plane))->direction, {1, 0}) == 0);
  }
  CHECK_FALSE(WeightedXY{}(Cloud{{{1, 1}, 1}}, one_plane({1, 0})));
  CHECK_FALSE(WeightedXY{}(Cloud{}, one_plane({1, 0})));
}

TEST_CASE("turned by 90 degrees with its failure planes the cloud carries the chosen line along") {
  for (const Vec2& plane : {x_direction, y_direction, Vec2{0.8, -0.6}}) {
    const auto line = WeightedXY{}(scattered_points(), one_plane(plane));
    const auto turned =
        WeightedXY{}(mapped(scattered_points(), perpendicular), one_plane(perpendicular(plane)));
    CHECK(off_angle(turned->direction, perpendicular(line->direction)) == near(0, 1e-14));
  }
}
