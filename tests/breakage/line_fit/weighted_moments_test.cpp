#include <riprap/breakage/line_fit/weighted_moments.hpp>

#include <doctest/doctest.h>

#include <support/near.hpp>
#include <support/point_clouds.hpp>

using namespace riprap;
using riprap::test::near;

TEST_CASE("weighted mean and central moments of three points") {
  // By hand: mean (10, 14) / 7; xx = 18 - 100/7, yy = 38 - 196/7, xy = 26 - 140/7.
  const WeightedMoments m = weighted_moments(test::three_points());
  CHECK(m.mean.x() == near(10.0 / 7, 1e-15));
  CHECK(m.mean.y() == near(2, 1e-15));
  CHECK(m.xx == near(26.0 / 7, 1e-14));
  CHECK(m.yy == near(10, 1e-14));
  CHECK(m.xy == near(6, 1e-14));
}

TEST_CASE("central moments keep their digits far from the origin") {
  const WeightedMoments here = weighted_moments(test::scattered_points());
  const Vec2 shift{4096, -2048};  // some thousand sizes, exact in binary
  const WeightedMoments there = weighted_moments(
      test::mapped(test::scattered_points(), [&](const Vec2& p) { return Vec2(p + shift); }));
  // The points themselves are rounded to 4096 * 1.1e-16 there; the printed form of eq. 5 would be
  // off by 4096 times as much again.
  CHECK(there.xx == near(here.xx, 2e-11));
  CHECK(there.yy == near(here.yy, 2e-11));
  CHECK(there.xy == near(here.xy, 2e-11));
  CHECK((there.mean - shift - here.mean).norm() == near(0, 2e-12));
}

TEST_CASE("points on a vertical or horizontal line spread in one direction only") {
  const auto spread = [](const test::Cloud& cloud) { return weighted_moments(cloud); };
  const WeightedMoments vertical = spread({{{3.3, 0}, 1}, {{3.3, 1}, 2}, {{3.3, 5}, 1}});
  CHECK_FALSE(vertical.spreads_in_x());
  CHECK(vertical.spreads_in_y());
  const WeightedMoments horizontal = spread({{{0, -0.7}, 1}, {{2, -0.7}, 2}});
  CHECK(horizontal.spreads_in_x());
  CHECK_FALSE(horizontal.spreads_in_y());
  const WeightedMoments point = spread({{{1, 2}, 1}, {{1, 2}, 5}});
  CHECK_FALSE(point.spreads_in_x());
  CHECK_FALSE(point.spreads_in_y());
  const WeightedMoments none = spread({});
  CHECK_FALSE(none.spreads_in_x());
  CHECK_FALSE(none.spreads_in_y());
}
