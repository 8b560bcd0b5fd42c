// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/circles.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/geometry/line_side.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

/// Of a point from the nearest edge [m], negative outside.
double depth_of(const Vec2& p, const ConvexPolygon& polygon) {
  double least = 1e9;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const LineSide edge(polygon[k], polygon[next_vertex(k, polygon.size())]);
    least = std::min(least, edge(p) / std::hypot(edge.x, edge.y));
  }
  return least;
}

}  // namespace

TEST_CASE("circles of regular polygons, rectangles and a right-angled triangle") {
  for (const Pose& pose : poses(1)) {
    const double round_off = 1e-12 * pose.digits;
    for (const std::size_t n : {3U, 4U, 5U, 12U, 64U}) {
      const ConvexPolygon polygon = pose.of(regular_polygon(n, 1));
      const Circle inside = inscribed_circle(polygon);
      CHECK(inside.radius == near(std::cos(pi / static_cast<double>(n)), 10 * round_off));
      CHECK((inside.centre - pose.of(Vec2{0, 0})).norm() < 1e-6);
      const Circle around = circumscribed_circle(polygon.ring());
      CHECK(around.radius == near(1, round_off));
      CHECK((around.centre - pose.of(Vec2{0, 0})).norm() < round_off);
    }
    const ConvexPolygon box = pose.of(rectangle(3, 1));
    CHECK(inscribed_circle(box).radius == near(0.5, 10 * round_off));
    // Any centre within 1 of the middle will do: it is the middle.
    CHECK((inscribed_circle(box).centre - pose.of(Vec2{0, 0})).norm() < 1e-6 * pose.digits);
    CHECK(circumscribed_circle(box.ring()).radius == near(0.5 * std::sqrt(10), round_off));
    // Legs of 3 and 4: the radius inside is half of what they exceed the long side by.
    const ConvexPolygon triangle = pose.of(ConvexPolygon{{0, 0}, {4, 0}, {0, 3}});
    CHECK(inscribed_circle(triangle).radius == near(1, 10 * round_off));
    CHECK((inscribed_circle(triangle).centre - pose.of(Vec2{1, 1})).norm() < 1e-6);
    CHECK(circumscribed_circle(triangle.ring()).radius == near(2.5, round_off));
    // An obtuse triangle has its longest side as diameter.
    const ConvexPolygon obtuse = pose.of(ConvexPolygon{{0, 0}, {4, 0}, {2, 0.5}});
    CHECK(circumscribed_circle(obtuse.ring()).radius == near(2, round_off));
  }
}

TEST_CASE("no point of a random polygon is deeper, no vertex outside, none can be drawn smaller") {
  Random random(2);
  for (int run = 0; run < 60; ++run) {
    const ConvexPolygon polygon = random_polygon({.most_vertices = 12}, 1, random);
    const Circle inside = inscribed_circle(polygon);
    CHECK(depth_of(inside.centre, polygon) == near(inside.radius, 1e-7));
    for (int k = 0; k < 2000; ++k) {
      const double x = random.uniform(-1, 1);
      CHECK(depth_of({x, random.uniform(-1, 1)}, polygon) <= inside.radius);
    }
    const Circle around = circumscribed_circle(polygon.ring());
    double least = 1e9;
    for (int k = 0; k < 2000; ++k) {
      const double x = random.uniform(-1, 1);
      const Vec2 centre{x, random.uniform(-1, 1)};
      double farthest = 0;
      for (const Vec2& v : polygon) farthest = std::max(farthest, (v - centre).norm());
      least = std::min(least, farthest);
    }
    CHECK(around.radius <= least);
    for (const Vec2& v : polygon) CHECK((v - around.centre).norm() <= around.radius * (1 + 1e-13));
  }
}

TEST_CASE("the largest circle of an outline is that of the convex polygon, to the tolerance") {
  Random random(3);
  for (int run = 0; run < 20; ++run) {
    const ConvexPolygon polygon = random_polygon({.most_vertices = 12}, 1, random);
    const double exact = inscribed_circle(polygon).radius;
    const Outline outline({polygon.begin(), polygon.end()});
    for (const double tolerance : {1e-2, 1e-4}) {
      const Circle inside = inscribed_circle(outline, tolerance);
      CHECK(inside.radius <= exact * (1 + 1e-10));
      CHECK(inside.radius * (1 + tolerance) >= exact * (1 - 1e-10));
      CHECK(depth_of(inside.centre, polygon) == near(inside.radius, 1e-14));
    }
  }
}

TEST_CASE("the largest circle of an L and of a U touches two sides and a concave corner") {
  // In an arm of width 1, from the outer corner: sqrt(2) (1 - r) = r.
  const double exact = 2 - std::sqrt(2);
  const Circle in_l = inscribed_circle(Outline({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}}));
  CHECK(in_l.radius <= exact);
  CHECK(in_l.radius * (1 + 1e-4) >= exact);
  // To first order in the error of the radius: it is a maximum with a corner.
  CHECK((in_l.centre - Vec2{exact, exact}).norm() < 10 * 1e-4);
  // The middle of its box is outside.
  const Circle in_u =
      inscribed_circle(Outline({{0, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 1}, {1, 1}, {1, 3}, {0, 3}}));
  CHECK(in_u.radius <= exact);
  CHECK(in_u.radius * (1 + 1e-4) >= exact);
  CHECK(message_of([] {
          (void)inscribed_circle(Outline({{0, 0}, {1, 0}, {0, 1}}), 1e-7);
        }) == "tolerance of the inscribed circle = 1e-07: must lie in [1e-6, 1)");
}

TEST_CASE("the circle of least squares is exact on a circle, and else meets its normal equations") {
  for (const Pose& pose : poses(1)) {
    std::vector<Vec2> arc;
    for (const double angle : {0.1, 0.3, 0.8, 1.2})
      arc.push_back(pose.of(Rotation::from_angle(angle) * Vec2{2, 0}));
    const Circle circle = least_squares_circle(arc);
    CHECK(circle.radius == near(2, 1e-13 * pose.digits));
    CHECK((circle.centre - pose.of(Vec2{0, 0})).norm() < 1e-13 * pose.digits);
  }
  const std::vector<Vec2> points{{1, 0}, {0.8, 0.7}, {0.1, 1.1}, {-0.7, 0.6}, {-1.1, 0.1}};
  const Circle circle = least_squares_circle(points);
  double sum = 0;
  Vec2 moment{0, 0};
  for (const Vec2& p : points) {
    const double residual = (p - circle.centre).squaredNorm() - circle.radius * circle.radius;
    CHECK(std::abs(residual) > 1e-3);
    sum += residual;
    moment += residual * p;
  }
  CHECK(sum == near(0, 1e-14));
  CHECK(moment.norm() < 1e-14);
}
