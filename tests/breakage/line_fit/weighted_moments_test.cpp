// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/line_fit/weighted_moments.hpp>

#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <string>

#include <riprap/breakage/line_fit/failure_plane_through_centroid.hpp>
#include <riprap/breakage/line_fit/total_least_squares.hpp>
#include <riprap/breakage/line_fit/weighted_xy.hpp>
#include <riprap/core/random.hpp>
#include <support/message_of.hpp>
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

TEST_CASE("points and weights that are no cloud are refused by name") {
  constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto refuse = [](std::vector<WeightedPoint> points, const char* rule) {
    const FailurePlanes planes{.count = 1};
    const auto text = [&](const auto& fit) {
      return test::message_of([&] { (void)fit(points, planes); });
    };
    for (const std::string& said : {text(WeightedX{}), text(WeightedY{}), text(WeightedXY{}),
                                    text(TotalLeastSquares{}), text(FailurePlaneThroughCentroid{})})
      CHECK(said == rule);
  };
  const Vec2 here{1, 2};
  refuse({{here, 1}, {here, -1}},
         "line fit: weight of a point = -1: must be a finite number, 0 or above");
  refuse({{here, nan_value}, {here, 1}},
         "line fit: weight of a point = nan: must be a finite number, 0 or above");
  refuse({{here, infinity}},
         "line fit: weight of a point = inf: must be a finite number, 0 or above");
  refuse({{here, 0}, {{3, 4}, 0}},
         "line fit: sum of the weights = 0: must be a finite number above 0");
  refuse({{here, 1}, {{nan_value, 0}, 1}}, "line fit: position of a point = nan: must be finite");
  refuse({{here, 1e300}, {{1e10, 0}, 1e300}},
         "line fit: second moment of the points = inf: must be a finite number");
}

TEST_CASE("clouds that determine no line give none, and no line has a part that is not a number") {
  Random random(5);
  int lines = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    std::vector<WeightedPoint> points;
    const unsigned count = random.uniform_integer(1, 4);
    for (unsigned i = 0; i < count; ++i) {
      const double scale = std::pow(10, random.uniform(-160, 20));
      const double weight = random.uniform(0, 1) < 0.2 ? 0 : std::pow(10, random.uniform(-300, 3));
      points.push_back({{scale * random.uniform(-1, 1), scale * random.uniform(-1, 1)}, weight});
    }
    points.push_back({{0, 0}, 1e-300});
    const FailurePlanes planes{.directions = {Vec2{0.6, 0.8}, Vec2{0.8, -0.6}}, .count = 2};
    const auto check = [&](const std::optional<Line>& line) {
      if (!line) return;
      ++lines;
      REQUIRE(is_finite(line->point));
      REQUIRE(std::abs(line->direction.norm() - 1) <= 1e-12);
    };
    check(WeightedX{}(points, planes));
    check(WeightedY{}(points, planes));
    check(WeightedXY{}(points, planes));
    check(TotalLeastSquares{}(points, planes));
    check(FailurePlaneThroughCentroid{}(points, planes));
  }
  CHECK(lines > 20'000);
}
