// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/regression_line.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::message_of;
using test::near;

namespace {

// Sums of a few numbers of order ten.
constexpr double round_off = 1e-13;

}  // namespace

TEST_CASE("points of a line give back the line") {
  std::vector<Vec2> points;
  for (const double x : {-2.0, 0.5, 1.0, 7.0}) points.push_back({x, 3 - 0.25 * x});
  const RegressionLine line = regression_line(points);
  CHECK(line.intercept == near(3, round_off));
  CHECK(line.slope == near(-0.25, round_off));
  CHECK(line.scatter == near(0, round_off));
}

TEST_CASE("the sum of squares along y is the least") {
  // By the normal equations, with means 2.5 and 7: Sxy = 7, Sxx = 5; the residuals are 1.1, -1.3,
  // -0.7 and 0.9.
  const std::vector<Vec2> points{{1, 6}, {2, 5}, {3, 7}, {4, 10}};
  const RegressionLine line = regression_line(points);
  CHECK(line.intercept == near(3.5, round_off));
  CHECK(line.slope == near(1.4, round_off));
  CHECK(line.scatter == near(std::sqrt(4.2 / 4), round_off));
}

TEST_CASE("the order of the points does not matter") {
  const RegressionLine one = regression_line(std::vector<Vec2>{{1, 6}, {2, 5}, {3, 7}, {4, 10}});
  const RegressionLine other = regression_line(std::vector<Vec2>{{3, 7}, {1, 6}, {4, 10}, {2, 5}});
  CHECK(one.intercept == near(other.intercept, round_off));
  CHECK(one.slope == near(other.slope, round_off));
}

TEST_CASE("one point, or points over one another, have no line") {
  CHECK(message_of([] {
          (void)regression_line(std::vector<Vec2>{{1, 2}});
        }) == "regression_line: number of points = 1: must be 2 or more");
  CHECK(message_of([] {
          (void)regression_line(std::vector<Vec2>{{4, 2}, {4, 3}});
        }) == "regression_line: x of all points = 4: must not be the same");
}
