// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/random_polygon.hpp>

#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <vector>

#include <support/message_of.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

/// Smallest angle between two neighbouring edges [degrees].
double smallest_corner(const ConvexPolygon& polygon) {
  double smallest = 180;
  const std::size_t n = polygon.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 to_next = polygon[(i + 1) % n] - polygon[i];
    const Vec2 to_previous = polygon[(i + n - 1) % n] - polygon[i];
    const double angle = std::atan2(cross(to_next, to_previous), to_next.dot(to_previous));
    smallest = std::min(smallest, angle * 180 / pi);
  }
  return smallest;
}

struct Mean {
  double sum = 0;
  double squares = 0;
  int count = 0;

  void add(double x) {
    sum += x;
    squares += x * x;
    ++count;
  }
  [[nodiscard]] double value() const { return sum / count; }
  [[nodiscard]] double variance() const { return squares / count - value() * value(); }
  [[nodiscard]] double standard_error() const { return std::sqrt(variance() / count); }
};

std::string complaint(const PolygonShape& shape) {
  return message_of([&] { shape.validate(); });
}

}  // namespace

TEST_CASE("polygons are sharp: smallest corner about 65 degrees, aspect about 1.72") {
  Random random(1);
  Mean corner;
  Mean slenderness;
  for (int i = 0; i < 20000; ++i) {
    const ConvexPolygon polygon = random_polygon({}, 1, random);
    corner.add(smallest_corner(polygon));
    slenderness.add(aspect(polygon.ring()));
  }
  // Means over 300000 polygons of an independent program with other random numbers, their standard
  // errors 0.042 and 0.00095; five standard errors of the difference.
  CHECK(std::abs(corner.value() - 65.172) <= 5 * std::hypot(corner.standard_error(), 0.042));
  CHECK(std::abs(slenderness.value() - 1.7207) <=
        5 * std::hypot(slenderness.standard_error(), 0.00095));
}

TEST_CASE("area is that of the circle and the centroid lies at the origin") {
  Random random(2);
  for (const double d : {1e-3, 0.016, 1.0, 40.0})
    for (int i = 0; i < 200; ++i) {
      const AreaProperties p = area_properties(random_polygon({}, d, random).ring());
      const double expected = pi * d * d / 4;
      // Round-off of a slender polygon's area is that of its diameter squared.
      CHECK(std::abs(p.area - expected) <= 1e-14 * expected);
      CHECK(p.centroid.norm() <= 1e-15 * d);
    }
}

TEST_CASE("numbers of vertices are the stated ones, each as often as the others") {
  Random random(3);
  constexpr int trials = 9000;
  std::array<int, 7> counts{};
  for (int i = 0; i < trials; ++i) {
    const ConvexPolygon polygon = random_polygon({}, 1, random);
    REQUIRE(polygon.size() >= 3);
    REQUIRE(polygon.size() <= 5);
    ++counts[polygon.size()];
  }
  // Five standard deviations of a binomial count with p = 1/3.
  for (const std::size_t n : {3u, 4u, 5u})
    CHECK(std::abs(counts[n] - trials / 3) <= 5 * std::sqrt(trials * 2.0 / 9));
}

TEST_CASE("without jitter on a circle a polygon is regular") {
  const PolygonShape shape{.fewest_vertices = 6,
                           .most_vertices = 6,
                           .smallest_axis_ratio = 1,
                           .largest_axis_ratio = 1,
                           .angle_jitter = 0};
  Random random(4);
  const ConvexPolygon hexagon = random_polygon(shape, 1, random);
  CHECK(hexagon.size() == 6);
  // A = 3 sqrt(3) / 2 r^2 = pi / 4.
  const double radius = std::sqrt(pi / 4 / (1.5 * std::sqrt(3.0)));
  for (const Vec2& v : hexagon) CHECK(std::abs(v.norm() - radius) <= 1e-15);
  CHECK(std::abs(smallest_corner(hexagon) - 120) <= 1e-12);
}

TEST_CASE("vertices of a polygon without jitter lie on an ellipse of the stated ratio") {
  const PolygonShape shape{.fewest_vertices = 64,
                           .most_vertices = 64,
                           .smallest_axis_ratio = 0.5,
                           .largest_axis_ratio = 0.5,
                           .angle_jitter = 0};
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    // The affine image of a regular 64-gon keeps its ratio of axes up to the polygon's own
    // departure from the circle, 1 - cos(pi / 64) = 1.2e-3.
    const double slenderness = aspect(random_polygon(shape, 1, random).ring());
    CHECK(std::abs(slenderness - 2) <= 2 * 1.3e-3);
  }
}

TEST_CASE("jitter makes polygons differ, and every direction is as good as another") {
  Random random(6);
  Mean c2;
  Mean s2;
  for (int i = 0; i < 5000; ++i) {
    // The longest diagonal's double angle averages out.
    const ConvexPolygon polygon = random_polygon({}, 1, random);
    Vec2 longest{0, 0};
    for (const Vec2& v : polygon)
      for (const Vec2& w : polygon)
        if ((v - w).norm() > longest.norm()) longest = v - w;
    const double angle = std::atan2(longest.y(), longest.x());
    c2.add(std::cos(2 * angle));
    s2.add(std::sin(2 * angle));
  }
  CHECK(std::abs(c2.value()) <= 5 * c2.standard_error());
  CHECK(std::abs(s2.value()) <= 5 * s2.standard_error());
}

TEST_CASE("the same seed gives the same polygons to the last bit") {
  Random a(7);
  Random b(7);
  for (int i = 0; i < 100; ++i) {
    const ConvexPolygon p = random_polygon({}, 0.016, a);
    const ConvexPolygon q = random_polygon({}, 0.016, b);
    REQUIRE(p.size() == q.size());
    for (std::size_t k = 0; k < p.size(); ++k) CHECK(p[k] == q[k]);
  }
}

TEST_CASE("extreme shapes within the rules are still convex polygons") {
  Random random(8);
  for (int i = 0; i < 300; ++i) {
    CHECK_NOTHROW((void)random_polygon({.most_vertices = 64, .angle_jitter = 0.99}, 1, random));
    CHECK_NOTHROW((void)random_polygon({.smallest_axis_ratio = 0.01}, 1, random));
  }
}

TEST_CASE("a shape's options are checked by name, value and rule") {
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  CHECK(complaint({}).empty());
  CHECK(complaint({.fewest_vertices = 2}) == "PolygonShape.fewest_vertices = 2: must be 3 or more");
  CHECK(complaint({.fewest_vertices = 6, .most_vertices = 5}) ==
        "PolygonShape.most_vertices = 5: must lie between fewest_vertices and 64");
  CHECK(complaint({.most_vertices = 65}) ==
        "PolygonShape.most_vertices = 65: must lie between fewest_vertices and 64");
  CHECK(complaint({.most_vertices = 64}).empty());
  for (const double ratio : {0.0, -1.0, 1.5, not_a_number})
    CHECK(complaint({.smallest_axis_ratio = ratio}) ==
          "PolygonShape.smallest_axis_ratio = " + to_text(ratio) + ": must lie in (0, 1]");
  for (const double ratio : {0.5, 1.1, not_a_number})
    CHECK(complaint({.largest_axis_ratio = ratio}) ==
          "PolygonShape.largest_axis_ratio = " + to_text(ratio) +
              ": must lie between smallest_axis_ratio and 1");
  CHECK(complaint({.angle_jitter = 0}).empty());
  for (const double jitter : {-0.1, 1.0, not_a_number})
    CHECK(complaint({.angle_jitter = jitter}) ==
          "PolygonShape.angle_jitter = " + to_text(jitter) + ": must lie in [0, 1)");
}
