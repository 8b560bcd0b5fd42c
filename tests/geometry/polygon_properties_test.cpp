// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/polygon_properties.hpp>

#include <doctest/doctest.h>
#include <vector>

#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

struct Case {
  ConvexPolygon polygon;
  AreaProperties expected;
  double size;
};

/// Closed forms of textbooks on statics; polar moments are about the centroid.
std::vector<Case> closed_forms() {
  std::vector<Case> cases;
  cases.push_back({unit_square(), {1, {0.5, 0.5}, 1.0 / 6}, 1.5});
  // Rectangle: b h (b^2 + h^2) / 12.
  cases.push_back({rectangle(3, 0.4), {1.2, {0, 0}, 1.2 * (9 + 0.16) / 12}, 3.1});
  // Triangle: A (a^2 + b^2 + c^2) / 36 with the three sides.
  cases.push_back({{{0, 0}, {3, 0}, {0, 4}}, {6, {1, 4.0 / 3}, 6 * (9 + 16 + 25) / 36.0}, 5});
  for (const std::size_t n : {3u, 4u, 5u, 8u, 64u}) {
    // Regular n-gon of circumradius r and central angle t: A = n r^2 sin t / 2, and
    // J = A r^2 (2 + cos t) / 6.
    const double r = 0.7;
    const double t = 2 * pi / static_cast<double>(n);
    const double area = 0.5 * static_cast<double>(n) * r * r * std::sin(t);
    const double polar = area * r * r * (2 + std::cos(t)) / 6;
    cases.push_back({regular_polygon(n, r), {area, {0, 0}, polar}, 1.4});
  }
  return cases;
}

}  // namespace

TEST_CASE("area, centroid and polar moment have their closed forms in every pose") {
  for (const Case& c : closed_forms())
    for (const Pose& pose : poses(c.size))
      for (std::size_t first = 0; first < c.polygon.size(); first += 3) {
        const AreaProperties p = area_properties(pose.of(begun_at(c.polygon, first)).ring());
        // Round-off of a sum over the vertices; coordinates far off have lost three digits.
        const double error = 2e-15 * pose.digits;
        CHECK(std::abs(p.area - c.expected.area) <= error * c.size * c.size);
        CHECK((p.centroid - pose.of(c.expected.centroid)).norm() <= error * c.size);
        CHECK(std::abs(p.polar_moment - c.expected.polar_moment) <= error * std::pow(c.size, 4));
      }
}

TEST_CASE("a mirror image has the same area and polar moment and the mirrored centroid") {
  const ConvexPolygon polygon{{0.1, 0}, {2, -1}, {3, 2}, {1, 3}};
  const AreaProperties p = area_properties(polygon.ring());
  const AreaProperties m = area_properties(mirrored(polygon).ring());
  CHECK(m.area == near_relative(p.area, 1e-15));
  CHECK(m.polar_moment == near_relative(p.polar_moment, 1e-14));
  CHECK((m.centroid - Vec2{-p.centroid.x(), p.centroid.y()}).norm() <= 2e-15);
}

TEST_CASE("in units f times smaller, area grows by f^2 and polar moment by f^4") {
  const ConvexPolygon polygon{{0.1, 0}, {2, -1}, {3, 2}, {1, 3}};
  const AreaProperties p = area_properties(polygon.ring());
  // Powers of two leave every digit as it is.
  for (const double f : {std::ldexp(1.0, -20), std::ldexp(1.0, 20)}) {
    const AreaProperties s = area_properties(scaled(polygon, f).ring());
    CHECK(s.area == f * f * p.area);
    CHECK(s.centroid == f * p.centroid);
    CHECK(s.polar_moment == f * f * f * f * p.polar_moment);
    CHECK(diameter(scaled(polygon, f).ring()) == f * diameter(polygon.ring()));
    CHECK(aspect(scaled(polygon, f).ring()) == aspect(polygon.ring()));
  }
}

TEST_CASE("a ring that is not convex has the moments of what it encloses") {
  // An L of three unit squares, first vertex away from the notch: its fan has a negative triangle.
  const std::vector<Vec2> ring = {{2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}, {0, 0}};
  const AreaProperties p = area_properties(ring);
  CHECK(p.area == near_relative(3, 1e-15));
  CHECK((p.centroid - Vec2{5.0 / 6, 5.0 / 6}).norm() <= 1e-15);
  // Three squares of 1/6 each, and the squared distances of their centres (.5, .5), (1.5, .5) and
  // (.5, 1.5) from the centroid.
  const double steiner = 2.0 / 9 + 2 * (4.0 / 9 + 1.0 / 9);
  CHECK(p.polar_moment == near_relative(3 * (1.0 / 6) + steiner, 1e-14));
}

TEST_CASE("fewer than three points have no area") {
  CHECK(area_properties({}).area == 0);
  const std::vector<Vec2> segment = {{3, 4}, {5, 6}};
  const AreaProperties p = area_properties(segment);
  CHECK(p.area == 0);
  CHECK(p.centroid == Vec2{3, 4});
  CHECK(p.polar_moment == 0);
  const std::vector<Vec2> flat = {{3, 4}, {5, 6}, {7, 8}};
  CHECK(area_properties(flat).area == 0);
  CHECK(area_properties(flat).centroid.allFinite());
}

TEST_CASE("diameter, least width and aspect have their closed forms in every pose") {
  struct Extent {
    ConvexPolygon polygon;
    double diameter;
    double width;
  };
  const double s = std::sqrt(3.0);
  const std::vector<Extent> cases = {
      {unit_square(), std::sqrt(2.0), 1},
      {rectangle(4, 3), 5, 3},
      {regular_polygon(3, 1), s, 1.5},
      {regular_polygon(6, 1), 2, s},
      // Regular pentagon: the diagonal, and the height from an edge to the opposite vertex.
      {regular_polygon(5, 1), 2 * std::sin(0.4 * pi), 1 + std::cos(0.2 * pi)},
      // Right triangle with sides 3, 4, 5: the height over the hypotenuse.
      {{{0, 0}, {3, 0}, {0, 4}}, 5, 2.4}};
  for (const Extent& c : cases)
    for (const Pose& pose : poses(c.diameter)) {
      const ConvexPolygon polygon = pose.of(c.polygon);
      const double error = 2e-15 * pose.digits;
      CHECK(std::abs(diameter(polygon.ring()) - c.diameter) <= error * c.diameter);
      CHECK(std::abs(least_width(polygon.ring()) - c.width) <= error * c.diameter);
      // Relative errors add up; that of the width is larger by this ratio.
      const double ratio = c.diameter / c.width;
      CHECK(aspect(polygon.ring()) == near_relative(ratio, (1 + ratio) * error));
    }
}

TEST_CASE("the extent of a rectangle along an axis is that of its diagonals' shadows") {
  for (const Pose& pose : poses(1)) {
    const ConvexPolygon polygon = pose.of(rectangle(3, 2));
    for (const double angle : {0.0, 0.4, 1.9, -2.6}) {
      const Vec2 axis = Rotation::from_angle(angle) * Vec2{1, 0};
      const double expected = 3 * std::abs(axis.x()) + 2 * std::abs(axis.y());
      CHECK(std::abs(extent_along(polygon.ring(), pose.rotation * axis) - expected) <=
            2e-15 * pose.digits);
    }
  }
}

TEST_CASE("the least width is the smallest shadow over all directions") {
  const ConvexPolygon polygon{{0, 0}, {2, -0.4}, {3, 1}, {1, 1.7}};
  double smallest = 1e9;
  constexpr int directions = 3600;
  for (int i = 0; i < directions; ++i) {
    const Vec2 n = Rotation::from_angle(pi * i / directions) * Vec2{1, 0};
    double low = 1e9;
    double high = -1e9;
    for (const Vec2& v : polygon) {
      low = std::min(low, n.dot(v));
      high = std::max(high, n.dot(v));
    }
    smallest = std::min(smallest, high - low);
  }
  const double width = least_width(polygon.ring());
  CHECK(width <= smallest);
  // The best direction is missed by half a step at most; the shadow changes by less than
  // the diameter times that angle.
  CHECK(width >= smallest - diameter(polygon.ring()) * 0.5 * pi / directions);
}

TEST_CASE("the perimeter of a right triangle of sides 3, 4 and 5") {
  const std::vector<Vec2> ring{{1, 1}, {5, 1}, {1, 4}};
  CHECK(perimeter(ring) == near(12, 1e-14));
}
