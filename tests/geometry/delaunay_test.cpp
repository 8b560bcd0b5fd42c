// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/delaunay.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <set>
#include <vector>

#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/point_lattice.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

double area(const TriangleIndices& t, const std::vector<Vec2>& points) {
  return 0.5 * cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
}

double total_area(const std::vector<TriangleIndices>& triangles, const std::vector<Vec2>& points) {
  double sum = 0;
  for (const TriangleIndices& t : triangles) sum += area(t, points);
  return sum;
}

/// Above 0 where q is inside the circle through the corners, which are counter-clockwise [m^4].
double in_circle(const TriangleIndices& t, const std::vector<Vec2>& points, const Vec2& q) {
  const Vec2 a = points[t[0]] - q;
  const Vec2 b = points[t[1]] - q;
  const Vec2 c = points[t[2]] - q;
  return a.dot(a) * cross(b, c) + b.dot(b) * cross(c, a) + c.dot(c) * cross(a, b);
}

}  // namespace

TEST_CASE("no point lies in the circle around a triangle, and the triangles fill the hull") {
  const double size = 0.3;
  const std::vector<Vec2> points = shaken_lattice(12, size, 0.35);
  const auto triangles = delaunay(points);
  // Euler: 2 n - 2 - h triangles of n points, of which h are on the hull.
  CHECK(triangles.size() > 2 * points.size() - 60);
  CHECK(triangles.size() < 2 * points.size());
  for (const TriangleIndices& t : triangles) {
    CHECK(area(t, points) > 0);
    for (const Vec2& q : points)
      // Rounding to 2^-30 of the extent moves the circle by as much.
      CHECK(in_circle(t, points, q) < 1e-8 * std::pow(size, 4));
  }
  std::set<std::uint32_t> used;
  for (const TriangleIndices& t : triangles) used.insert(t.begin(), t.end());
  CHECK(used.size() == points.size());
}

TEST_CASE("a square grid, four points on every circle, is cut into triangles without gaps") {
  std::vector<Vec2> points;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 4; ++j) points.emplace_back(0.1 * i, 0.1 * j);
  const auto triangles = delaunay(points);
  CHECK(triangles.size() == 24);
  for (const TriangleIndices& t : triangles) CHECK(area(t, points) == near(0.005, 1e-15));
}

TEST_CASE("points on a circle have one polygon, cut into triangles") {
  std::vector<Vec2> points;
  for (int k = 0; k < 12; ++k) {
    const double angle = 2 * std::numbers::pi * k / 12;
    points.emplace_back(7 + std::cos(angle), std::sin(angle) - 3);
  }
  const auto triangles = delaunay(points);
  CHECK(triangles.size() == 10);
  CHECK(total_area(triangles, points) == near(3, 1e-13));  // of the regular dodecagon
}

TEST_CASE("too few points, points on a line and one point twice give no triangle of their own") {
  CHECK(delaunay(std::vector<Vec2>{}).empty());
  CHECK(delaunay(std::vector<Vec2>{{1, 2}}).empty());
  CHECK(delaunay(std::vector<Vec2>{{1, 2}, {3, 4}}).empty());
  CHECK(delaunay(std::vector<Vec2>{{1, 1}, {2, 2}, {3, 3}, {5, 5}}).empty());
  CHECK(delaunay(std::vector<Vec2>{{1, 1}, {1, 1}, {1, 1}}).empty());
  CHECK(delaunay(std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1}, {0, 0}}).size() == 1);
}

TEST_CASE("far from the origin the triangles are the same") {
  std::vector<Vec2> points = shaken_lattice(6, 1, 0.3);
  const auto triangles = delaunay(points);
  for (Vec2& p : points) p = Vec2{0x1p20, -0x1p21} + p;
  CHECK(delaunay(points) == triangles);
}

TEST_CASE("a point that is not finite is refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(contains(message_of([&] {
                   (void)delaunay(std::vector<Vec2>{{0, 0}, {nan, 1}, {1, 0}});
                 }),
                 "delaunay: coordinate of a point = nan"));
}

TEST_CASE("flat triangles at the edge are taken off, one after the other, and others stay") {
  // A fan from the top to four points on a shallow arc, whose own triangles are flat.
  const std::vector<Vec2> points{{0, 1}, {-1, 0}, {-0.3, -0.05}, {0.3, -0.05}, {1, 0}};
  // 1-2-3 and 1-3-4 fill the arc, the inner one behind no edge at first.
  const std::vector<TriangleIndices> triangles{{0, 1, 4}, {1, 3, 4}, {1, 2, 3}};
  for (const TriangleIndices& t : triangles) REQUIRE(area(t, points) > 0);
  // 1-2-3: its sides on the edge are 1-2, height over side 0.06, and 2-3.
  CHECK(without_flat_edge(triangles, points, 0.05).size() == 3);
  const auto left = without_flat_edge(triangles, points, 0.1);
  REQUIRE(left.size() == 1);
  CHECK(left[0] == triangles[0]);
  CHECK(without_flat_edge(triangles, points, 0) == triangles);
  CHECK(without_flat_edge({}, points, 0.1).empty());
  CHECK(contains(message_of([&] { (void)without_flat_edge({}, points, -1); }), "least_height"));
}
