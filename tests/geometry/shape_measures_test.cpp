// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/shape_measures.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

/// 64 vertices on an ellipse with these half axes.
ConvexPolygon ellipse_like(double a, double b) {
  std::vector<Vec2> vertices;
  for (const Vec2& v : regular_polygon(64, 1)) vertices.push_back({a * v.x(), b * v.y()});
  return ConvexPolygon(std::move(vertices));
}

}  // namespace

TEST_CASE("regular polygons have closed forms") {
  for (const Pose& pose : poses(1))
    for (const std::size_t n : {3U, 4U, 5U, 6U, 12U, 64U}) {
      const ConvexPolygon polygon = pose.of(regular_polygon(n, 1));
      const double half_angle = pi / static_cast<double>(n);
      // 4 pi (n / 2) sin(2 h) over (2 n sin h)^2
      CHECK(circularity(polygon.ring()) ==
            near_relative(half_angle / std::tan(half_angle), 1e-12 * pose.digits));
      CHECK(sphericity(polygon) == near(std::cos(half_angle), 1e-11 * pose.digits));
      CHECK(moment_elongation(polygon.ring()) == near(1, 1e-10 * pose.digits));
      CHECK(convexity(polygon.ring()) == near(1, 1e-13 * pose.digits));
      // The distances of all tips enter: an error of the centre cancels to first order.
      CHECK(angularity(polygon) == near_relative(2 * pi / std::cos(half_angle), 1e-6));
    }
  CHECK(elongation(regular_polygon(4, 1).ring()) == near(1, 1e-14));
  CHECK(elongation(regular_polygon(6, 1).ring()) == near(2 / std::sqrt(3), 1e-14));
  // 720 degrees of an equilateral triangle.
  CHECK(angularity(regular_polygon(3, 1)) == near(4 * pi, 1e-5));
}

TEST_CASE("rectangles have closed forms") {
  for (const Pose& pose : poses(1))
    for (const double a : {1.0, 1.5, 4.0, 10.0}) {
      const ConvexPolygon polygon = pose.of(rectangle(a, 1));
      CHECK(elongation(polygon.ring()) == near_relative(a, 1e-12 * pose.digits));
      CHECK(moment_elongation(polygon.ring()) == near_relative(a, 1e-10 * pose.digits));
      CHECK(aspect(polygon.ring()) == near_relative(std::hypot(a, 1), 1e-12 * pose.digits));
      CHECK(circularity(polygon.ring()) ==
            near_relative(pi * a / ((a + 1) * (a + 1)), 1e-12 * pose.digits));
      CHECK(sphericity(polygon) == near_relative(1 / std::hypot(a, 1), 1e-11 * pose.digits));
      CHECK(angularity(polygon) == near_relative(2 * pi * std::hypot(a, 1), 1e-6));
    }
}

TEST_CASE("polygons on an ellipse come near the ellipse") {
  for (const double a : {1.0, 2.0, 5.0}) {
    const ConvexPolygon polygon = ellipse_like(a, 1);
    // An affine image of a regular polygon: exact.
    CHECK(moment_elongation(polygon.ring()) == near_relative(a, 1e-12));
    // The rectangle is along the axes but for the cut of an edge, 1 - cos(pi / 64) at most.
    CHECK(elongation(polygon.ring()) == near_relative(a, 0.002));
    // In the ellipse, and hardly smaller than its least circle.
    CHECK(sphericity(polygon) == near_relative(1 / a, 0.005));
  }
  // Ramanujan's perimeter of an ellipse of 2 by 1, 9.68845.
  CHECK(circularity(ellipse_like(2, 1).ring()) ==
        near_relative(4 * pi * 2 * pi / (9.68845 * 9.68845), 1e-3));
}

TEST_CASE("a corner counts by its angle and its distance: a right-angled triangle") {
  // Legs of 3 and 4 around a circle of radius 1 at (1, 1).
  const ConvexPolygon triangle{{0, 0}, {4, 0}, {0, 3}};
  const double expected = 0.5 * pi * std::sqrt(2) + (pi - std::atan2(3, 4)) * std::sqrt(10) +
                          (pi - std::atan2(4, 3)) * std::sqrt(5);
  CHECK(angularity(triangle) == near(expected, 1e-5));
}

TEST_CASE("concave outlines: a plus and an L") {
  const std::vector<Vec2> plus{{1, 0}, {2, 0}, {2, 1}, {3, 1}, {3, 2}, {2, 2},
                               {2, 3}, {1, 3}, {1, 2}, {0, 2}, {0, 1}, {1, 1}};
  CHECK(convexity(plus) == near(5.0 / 7, 1e-15));
  CHECK(circularity(plus) == near(4 * pi * 5 / 144, 1e-15));
  CHECK(moment_elongation(plus) == near(1, 1e-14));
  CHECK(elongation(plus) == near(1, 1e-14));
  const std::vector<Vec2> l_shape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  CHECK(convexity(l_shape) == near(3 / 3.5, 1e-15));
  // About its centroid (5/6, 5/6): xx = yy = 11/12, xy = -1/3, so that the ratio is 1.25 / (7/12).
  CHECK(moment_elongation(l_shape) == near(std::sqrt(15.0 / 7), 1e-14));
}
