// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/bounding_rectangle.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/core/random.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

TEST_CASE("a rectangle is its own, in every pose") {
  for (const Pose& pose : poses(1)) {
    const ConvexPolygon polygon = pose.of(rectangle(3, 0.5));
    const BoundingRectangle box = least_area_rectangle(polygon.ring());
    CHECK(box.length == near(3, 1e-13 * pose.digits));
    CHECK(box.width == near(0.5, 1e-13 * pose.digits));
    const Vec2 along = pose.rotation * Vec2{1, 0};
    CHECK(std::abs(cross(box.direction, along)) < 1e-12 * pose.digits);
  }
}

TEST_CASE("an equilateral triangle, a hexagon, a plus") {
  const BoundingRectangle triangle = least_area_rectangle(regular_polygon(3, 1).ring());
  CHECK(triangle.length == near(std::sqrt(3), 1e-14));
  CHECK(triangle.width == near(1.5, 1e-14));
  const BoundingRectangle hexagon = least_area_rectangle(regular_polygon(6, 1, 0.3).ring());
  CHECK(hexagon.length == near(2, 1e-14));
  CHECK(hexagon.width == near(std::sqrt(3), 1e-14));
  // Arms of 3 by 1: along an edge of the hull that is slanted, 4 / sqrt 2 wide.
  const std::vector<Vec2> plus{{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2},
                               {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
  CHECK(least_area_rectangle(plus).area() == near(8, 1e-14));
}

TEST_CASE("no rectangle in any direction is smaller") {
  Random random(8);
  for (int run = 0; run < 30; ++run) {
    const ConvexPolygon polygon = random_polygon({.most_vertices = 9}, 1, random);
    const double least = least_area_rectangle(polygon.ring()).area();
    double found = 1e9;
    for (int k = 0; k < 2000; ++k) {
      const Vec2 along = Rotation::from_angle(pi * k / 2000) * Vec2{1, 0};
      found = std::min(found, extent_along(polygon.ring(), along) *
                                  extent_along(polygon.ring(), perpendicular(along)));
    }
    CHECK(least <= found * (1 + 1e-14));
    // The area changes by no more than its size with the angle: half a step off the best.
    CHECK(least > found * (1 - 5 * pi / 2000));
  }
}
