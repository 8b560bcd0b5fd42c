// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/splitter/straight_cut.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <numbers>
#include <vector>

#include <riprap/geometry/random_polygon.hpp>
#include <support/near.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::near_relative;

namespace {

const std::vector<Vec2> unit_square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};

Line upright(double x) { return {{x, 0.5}, {0, 1}}; }

// Without the sliver rule.
constexpr StraightCut permissive{.minimum_area = 0, .maximum_aspect = 1e6};

}  // namespace

TEST_CASE("a unit square cut at x = 0.3") {
  const auto parts = permissive(unit_square, upright(0.3), 1);
  REQUIRE(parts);
  const AreaProperties left = area_properties(parts->left);
  const AreaProperties right = area_properties(parts->right);
  CHECK(left.area == near(0.3, 1e-15));
  CHECK(right.area == near(0.7, 1e-15));
  CHECK((left.centroid - Vec2{0.15, 0.5}).norm() == near(0, 1e-15));
  CHECK((right.centroid - Vec2{0.65, 0.5}).norm() == near(0, 1e-15));
  CHECK(left.polar_moment == near(0.3 * (0.09 + 1) / 12, 1e-15));
  CHECK(right.polar_moment == near(0.7 * (0.49 + 1) / 12, 1e-15));
  // Polar moment about the common centroid is that of the whole, 1/6.
  const double whole =
      left.polar_moment + left.area * 0.35 * 0.35 + right.polar_moment + right.area * 0.15 * 0.15;
  CHECK(whole == near(1.0 / 6, 1e-15));
}

TEST_CASE("cuts that leave less than the least area are refused") {
  const StraightCut rule{.minimum_area = 0.08, .maximum_aspect = 1e6};
  CHECK_FALSE(rule(unit_square, upright(0.079), 1));
  CHECK(rule(unit_square, upright(0.081), 1));
  // Either piece may be the small one.
  CHECK_FALSE(rule(unit_square, upright(0.921), 1));
  CHECK(rule(unit_square, upright(0.919), 1));
}

TEST_CASE("the least area is a share of the mean particle, not of the one that breaks") {
  const StraightCut rule{.minimum_area = 0.08, .maximum_aspect = 1e6};
  CHECK(rule(unit_square, upright(0.3), 3.7));
  CHECK_FALSE(rule(unit_square, upright(0.3), 3.8));
  CHECK(rule(unit_square, upright(0.04), 0.49));
}

TEST_CASE("cuts that leave a piece too slender are refused") {
  // A strip of width w has the aspect sqrt(1 + w^2) / w, which is 3 at w = 1 / sqrt(8).
  const StraightCut rule{.minimum_area = 0, .maximum_aspect = 3};
  const double limit = 0.35355339;
  CHECK(rule(unit_square, upright(limit + 1e-6), 1));
  CHECK_FALSE(rule(unit_square, upright(limit - 1e-6), 1));
  CHECK_FALSE(rule(unit_square, upright(1 - limit + 1e-6), 1));
}

TEST_CASE("the default rule needs 8 % of the mean area and an aspect of at most 3") {
  const StraightCut rule;
  CHECK(rule.minimum_area == 0.08);
  CHECK(rule.maximum_aspect == 3);
  CHECK(rule(unit_square, upright(0.5), 1));
  CHECK_FALSE(rule(unit_square, upright(0.2), 1));   // too slender
  CHECK_FALSE(rule(unit_square, upright(0.5), 10));  // too small
}

TEST_CASE("with dust a piece below the least area is cut off, however slender") {
  const StraightCut rule{.minimum_area = 0.08, .maximum_aspect = 3, .dust = true};
  for (const double x : {0.079, 0.921, 0.01}) {
    const auto parts = rule(unit_square, upright(x), 1);
    REQUIRE(parts);
    CHECK(rule.is_dust(parts->left, 1) == (x < 0.5));
    CHECK(rule.is_dust(parts->right, 1) == (x > 0.5));
  }
  CHECK_FALSE(rule(unit_square, upright(0.081), 1));  // kept, and too slender
  const auto halves = rule(unit_square, upright(0.5), 1);
  REQUIRE(halves);
  CHECK_FALSE(rule.is_dust(halves->left, 1));
  CHECK_FALSE(rule.is_dust(halves->right, 1));
  // What is left of the particle has to be acceptable.
  CHECK_FALSE(StraightCut{.minimum_area = 0.7, .maximum_aspect = 1.4, .dust = true}(
      unit_square, upright(0.25), 1));
  // Without the option nothing is dust.
  CHECK_FALSE(StraightCut{}.is_dust(unit_square, 1e9));
}

TEST_CASE("a line that misses the particle cuts nothing") {
  CHECK_FALSE(permissive(unit_square, upright(1.5), 1));
  CHECK_FALSE(permissive(unit_square, upright(0), 1));                             // along an edge
  CHECK_FALSE(permissive(unit_square, Line{{0, 1}, Vec2{1, 1}.normalized()}, 1));  // at a corner
}

TEST_CASE("without limits every line that runs through a particle cuts it into two polygons") {
  constexpr StraightCut unlimited{.minimum_area = 0,
                                  .maximum_aspect = std::numeric_limits<double>::infinity()};
  unlimited.validate();
  Random random(601);
  double least = 1;
  for (int sample = 0; sample < 500; ++sample) {
    const ConvexPolygon polygon = random_polygon({}, 1, random);
    const Rotation turn = Rotation::from_angle(random.uniform(0, 7));
    const Vec2 through = random.uniform(0, 0.99) * polygon[0];
    const auto parts = unlimited(polygon.ring(), Line{through, turn * Vec2{1, 0}}, 1);
    REQUIRE(parts);
    const double left = area_properties(ConvexPolygon(parts->left).ring()).area;
    const double right = area_properties(ConvexPolygon(parts->right).ring()).area;
    CHECK(left + right == near_relative(area_properties(polygon.ring()).area, 1e-14));
    least = std::min({least, left, right});
  }
  CHECK(least < 1e-3);  // slivers too
}

TEST_CASE("the rule does not depend on place, direction or unit of length") {
  const StraightCut rule;
  for (const double angle : {0.0, 0.77, 2.5})
    for (const double scale : {1.0, 1e-3}) {
      const Rotation turn = Rotation::from_angle(angle);
      const Vec2 shift = scale * Vec2{500, -800};
      const auto move = [&](const Vec2& p) { return Vec2(turn * (scale * p) + shift); };
      std::vector<Vec2> ring;
      for (const Vec2& v : unit_square) ring.push_back(move(v));
      const double mean = scale * scale;
      for (const double x : {0.353, 0.354, 0.5, 0.646, 0.647}) {
        CAPTURE(x);
        const Line line{move({x, 0.5}), turn * Vec2{0, 1}};
        const auto parts = rule(ring, line, mean);
        REQUIRE(parts.has_value() == rule(unit_square, upright(x), 1).has_value());
        if (parts)
          // Coordinates are rounded to about 1000 sizes * 1.1e-16.
          CHECK(area_properties(parts->left).area / mean == near(x, 1e-12));
      }
    }
}

TEST_CASE("rules of the sliver rule") {
  CHECK_NOTHROW(permissive.validate());
  CHECK_THROWS_WITH_AS(StraightCut{.minimum_area = -0.1}.validate(),
                       "StraightCut.minimum_area = -0.1: must be a finite number, 0 or above",
                       InvalidInput);
  CHECK_THROWS_WITH_AS(StraightCut{.maximum_aspect = 0.5}.validate(),
                       "StraightCut.maximum_aspect = 0.5: must be 1 or more", InvalidInput);
}

TEST_CASE("pieces are polygons that add up to the whole, or the cut is refused") {
  const std::vector<Vec2> bevelled{{0, 0}, {1, 0}, {1, .9987}, {.9987, 1}, {0, 1}};
  const auto parts = StraightCut{}(bevelled, Line{{0, 0}, Vec2{1, 1}.normalized()}, 1);
  REQUIRE(parts);
  CHECK(polygon_area(parts->left) + polygon_area(parts->right) ==
        near_relative(polygon_area(bevelled), 1e-15));

  Random random(13);
  int cuts = 0;
  int faults = 0;
  constexpr StraightCut unlimited{.minimum_area = 0, .maximum_aspect = 1e9};
  for (int sample = 0; sample < 20'000; ++sample) {
    const ConvexPolygon polygon = random_polygon({.most_vertices = 64}, 1, random);
    const Rotation turn = Rotation::from_angle(random.uniform(0, 7));
    const Vec2 through = random.uniform(0.9, 1) * polygon[0];  // near a corner
    const auto pieces = unlimited(polygon.ring(), Line{through, turn * Vec2{1, 0}}, 1);
    if (!pieces) continue;
    ++cuts;
    faults += !try_convex_polygon(pieces->left) || !try_convex_polygon(pieces->right);
  }
  CHECK(cuts > 10'000);
  CHECK(faults == 0);
}

TEST_CASE("a cut that would leave a piece of 65 vertices is refused") {
  std::vector<Vec2> ring;
  for (int i = 0; i < 64; ++i) {
    const Rotation at = Rotation::from_angle(2 * std::numbers::pi * i / 64);
    ring.push_back({at.cosine, at.sine});
  }
  // Across both edges of vertex 0: a triangle on one side, 65 vertices on the other.
  CHECK_FALSE(permissive(ring, upright(0.998), 1));
  ring.pop_back();
  CHECK(permissive(ring, upright(0.998), 1));
}
