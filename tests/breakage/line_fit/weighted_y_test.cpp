// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/line_fit/weighted_y.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/breakage/line_fit/weighted_x.hpp>
#include <support/near.hpp>
#include <support/point_clouds.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

std::optional<Line> fit(const Cloud& cloud) { return WeightedY{}(cloud, FailurePlanes{}); }
double slope(const Line& line) { return line.direction.y() / line.direction.x(); }
double intercept(const Line& line) { return line.point.y() - slope(line) * line.point.x(); }

// Sum of w (y - m x - b)^2.
double misfit(const Cloud& cloud, double m, double b) {
  double sum = 0;
  for (const WeightedPoint& p : cloud) {
    const double r = p.position.y() - m * p.position.x() - b;
    sum += p.weight * r * r;
  }
  return sum;
}

}  // namespace

TEST_CASE("the Y line through three weighted points") {
  const auto line = fit(three_points());
  REQUIRE(line);
  CHECK(slope(*line) == near(21.0 / 13, 1e-14));      // 1.6153846
  CHECK(intercept(*line) == near(-4.0 / 13, 1e-14));  // -0.3076923
  CHECK(line->direction.norm() == near(1, 1e-15));
}

TEST_CASE("no other line has less weighted vertical misfit than the Y line") {
  const Cloud cloud = scattered_points();
  const auto line = fit(cloud);
  REQUIRE(line);
  const double m = slope(*line);
  const double b = intercept(*line);
  const double least = misfit(cloud, m, b);
  for (const double dm : {-1e-3, 0.0, 1e-3})
    for (const double db : {-1e-3, 0.0, 1e-3})
      if (dm != 0 || db != 0) CHECK(misfit(cloud, m + dm, b + db) > least);
}

TEST_CASE("only the ratios of the weights matter to a Y line") {
  Cloud heavy = scattered_points();
  for (WeightedPoint& p : heavy) p.weight *= 512;  // exact in binary
  CHECK(fit(heavy)->direction == fit(scattered_points())->direction);
}

TEST_CASE("the Y line far from the origin is the shifted line") {
  const Vec2 shift{3000, -7000};
  const auto here = fit(scattered_points());
  const auto there =
      fit(mapped(scattered_points(), [&](const Vec2& p) { return Vec2(p + shift); }));
  REQUIRE(there);
  // Positions are rounded to 7000 * 1.1e-16 there.
  CHECK(off_angle(there->direction, here->direction) == near(0, 1e-11));
  CHECK(there->left_distance(here->point + shift) == near(0, 1e-11));
}

TEST_CASE("a cloud mirrored or turned half round carries its Y line along") {
  const auto line = fit(scattered_points());
  const auto check = [&](auto&& map) {
    const auto image = fit(mapped(scattered_points(), map));
    REQUIRE(image);
    CHECK(off_angle(image->direction, map(line->direction)) == near(0, 1e-14));
    CHECK(image->left_distance(map(line->point)) == near(0, 1e-14));
  };
  check([](const Vec2& p) { return Vec2{-p.x(), p.y()}; });
  check([](const Vec2& p) { return Vec2{p.x(), -p.y()}; });
  check([](const Vec2& p) { return Vec2{-p.x(), -p.y()}; });
  check([](const Vec2& p) { return Vec2{2.5 * p.x(), 2.5 * p.y()}; });
}

TEST_CASE("a Y line is not the Y line of the turned cloud unless the points lie on a line") {
  const Rotation turn = Rotation::from_angle(0.6);
  const auto rotate = [&](const Vec2& p) { return Vec2(turn * p); };
  const auto line = fit(scattered_points());
  const auto turned = fit(mapped(scattered_points(), rotate));
  // The method depends on the axes: some degrees for this cloud.
  CHECK(off_angle(turned->direction, turn * line->direction) > 0.05);

  const Cloud straight{{{0, 0}, 1}, {{1, 0.5}, 3}, {{3, 1.5}, 2}};
  for (const double angle : {0.1, 0.9, 2.2, -1.3}) {
    const Rotation r = Rotation::from_angle(angle);
    const auto image = fit(mapped(straight, [&](const Vec2& p) { return Vec2(r * p); }));
    REQUIRE(image);
    CHECK(off_angle(image->direction, r * Vec2{2, 1}) == near(0, 1e-14));
  }
}

TEST_CASE("a vertical cloud has no Y line, a horizontal one has") {
  CHECK_FALSE(fit({{{1.7, 0}, 1}, {{1.7, 2}, 1}, {{1.7, 3}, 4}}));
  CHECK_FALSE(fit({{{1e3 + 0.1, 0}, 1}, {{1e3 + 0.1, 2}, 1}}));
  const auto flat = fit({{{0, 4}, 1}, {{1, 4}, 2}});
  REQUIRE(flat);
  CHECK(off_angle(flat->direction, Vec2{1, 0}) == 0);
  CHECK(flat->left_distance({9, 4}) == 0);
}

TEST_CASE("one point and no point determine no Y line") {
  CHECK_FALSE(fit({}));
  CHECK_FALSE(fit({{{1, 2}, 3}}));
}
