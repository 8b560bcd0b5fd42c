// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/line_fit/total_least_squares.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/breakage/line_fit/weighted_x.hpp>
#include <riprap/breakage/line_fit/weighted_y.hpp>
#include <support/near.hpp>
#include <support/point_clouds.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

std::optional<Line> fit(const Cloud& cloud) { return TotalLeastSquares{}(cloud, FailurePlanes{}); }

// Weighted sum of squared distances from a line.
double misfit(const Cloud& cloud, const Line& line) {
  double sum = 0;
  for (const WeightedPoint& p : cloud) {
    const double d = line.left_distance(p.position);
    sum += p.weight * d * d;
  }
  return sum;
}

}  // namespace

TEST_CASE("the principal axis of three weighted points") {
  // Central moments 26/7, 10 and 6: tan 2 angle = 12 / (26/7 - 10), in the second quadrant.
  const auto line = fit(three_points());
  REQUIRE(line);
  const double angle = 0.5 * std::atan2(12.0, 26.0 / 7 - 10);
  CHECK(off_angle(line->direction, {std::cos(angle), std::sin(angle)}) == near(0, 1e-14));
  CHECK(line->left_distance({10.0 / 7, 2}) == near(0, 1e-15));
  CHECK(line->direction.norm() == near(1, 1e-15));
}

TEST_CASE("no other line has less weighted distance from the points") {
  const Cloud cloud = scattered_points();
  const auto line = fit(cloud);
  REQUIRE(line);
  const double least = misfit(cloud, *line);
  for (const double turn : {-0.01, 0.0, 0.01})
    for (const double shift : {-0.01, 0.0, 0.01}) {
      if (turn == 0 && shift == 0) continue;
      const Line other{line->point + shift * perpendicular(line->direction),
                       Rotation::from_angle(turn) * line->direction};
      CHECK(misfit(cloud, other) > least);
    }
  // Quarter turn: the worst line through the centroid.
  CHECK(misfit(cloud, {line->point, perpendicular(line->direction)}) > least);
}

TEST_CASE("the principal axis turns, shifts and mirrors with the cloud") {
  const auto line = fit(scattered_points());
  const auto check = [&](auto&& map, auto&& map_direction, double tolerance) {
    const auto image = fit(mapped(scattered_points(), map));
    REQUIRE(image);
    CHECK(off_angle(image->direction, map_direction(line->direction)) == near(0, tolerance));
    CHECK(image->left_distance(map(line->point)) == near(0, tolerance));
  };
  for (const double angle : {0.1, 0.9, 1.7, 3.0}) {
    const Rotation turn = Rotation::from_angle(angle);
    const auto rotate = [&](const Vec2& p) { return Vec2(turn * p); };
    check(rotate, rotate, 1e-14);
    // Positions are rounded to some 1e4 * 1.1e-16 far from the origin.
    check([&](const Vec2& p) { return Vec2(turn * p + Vec2{8000, -3000}); }, rotate, 2e-11);
  }
  const auto mirror = [](const Vec2& p) { return Vec2{-p.x(), p.y()}; };
  check(mirror, mirror, 1e-14);
}

TEST_CASE("the principal axis lies between the Y and the X line") {
  const double tls =
      std::atan2(fit(three_points())->direction.y(), fit(three_points())->direction.x());
  CHECK(std::tan(tls) > 21.0 / 13);
  CHECK(std::tan(tls) < 1 / 0.6);
}

TEST_CASE("vertical and horizontal clouds have principal axes, round ones have none") {
  CHECK(off_angle(fit({{{2, 0}, 1}, {{2, 5}, 3}})->direction, {0, 1}) == near(0, 1e-15));
  CHECK(off_angle(fit({{{0, 2}, 1}, {{5, 2}, 3}})->direction, {1, 0}) == near(0, 1e-15));
  CHECK_FALSE(fit({{{1, 0}, 1}, {{0, 1}, 1}, {{-1, 0}, 1}, {{0, -1}, 1}}));
  CHECK_FALSE(fit({{{1, 2}, 3}}));
  CHECK_FALSE(fit({}));
}
