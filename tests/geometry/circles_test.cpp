// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/circles.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <riprap/core/random.hpp>
#include <riprap/geometry/line_side.hpp>
#include <riprap/geometry/random_polygon.hpp>
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
