// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/narrow_phase/polygon_moments.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <support/near.hpp>

using namespace riprap;
using test::near;
using test::near_relative;

namespace {

// Width s along x, depth d along y; b, whose lower edge is in it, lies on a.
OverlapPolygon slab(double s, double d) {
  OverlapPolygon polygon;
  polygon.push({2, 1}, {true, 0});
  polygon.push({2 + s, 1}, {false, 0});
  polygon.push({2 + s, 1 + d}, {false, 0});
  polygon.push({2, 1 + d}, {false, 0});
  for (std::size_t i = 0; i < 4; ++i) polygon.sources[i].of_b = i == 0;
  return polygon;
}

}  // namespace

TEST_CASE("moments of a rectangle with one edge of b") {
  const double s = 0.6;
  const double d = 0.1;
  const PolygonMoments m = polygon_moments(slab(s, d));
  CHECK(m.area == near_relative(s * d, 1e-14));
  CHECK((m.centroid - Vec2{2 + 0.5 * s, 1 + 0.5 * d}).norm() <= 1e-15);
  // W = k s^2 d^2 / (s^2 + d^2) = k depth^2 / 2.
  const double squared = s * s + d * d;
  CHECK(m.depth == near_relative(std::sqrt(2 / squared) * s * d, 1e-14));
  // Upwards: the overlap shrinks as b rises.
  CHECK(m.depth * m.gradient.y() ==
        near_relative(2 * std::pow(s, 4) * d / (squared * squared), 1e-13));
  CHECK(m.gradient.x() == near(0, 1e-14));
  CHECK(m.rotation == near(0, 1e-14));
}

TEST_CASE("an overlap with edges of one ring only has no gradient") {
  for (const bool of_b : {false, true}) {
    OverlapPolygon polygon = slab(0.6, 0.1);
    for (std::size_t i = 0; i < 4; ++i) polygon.sources[i].of_b = of_b;
    const PolygonMoments m = polygon_moments(polygon);
    CHECK(m.depth > 0.1);
    CHECK(m.gradient.norm() <= 1e-14);
    CHECK(std::abs(m.rotation) <= 1e-14);
  }
}

TEST_CASE("two bars of equal width across each other have neither force nor couple") {
  // The sides along y are a's, those along x are b's.
  OverlapPolygon polygon = slab(0.6, 0.1);
  for (std::size_t i = 0; i < 4; ++i) polygon.sources[i].of_b = i % 2 == 0;
  const PolygonMoments m = polygon_moments(polygon);
  CHECK(m.gradient.norm() <= 1e-14);
  CHECK(std::abs(m.rotation) <= 1e-14);
  // Bars of equal width w at an angle q have a rhombus of side w / sin q in common, with
  // det S = (A w / (12 sin q))^2 sin^2 q and tr S = A w^2 / (6 sin^2 q): the depth is w whatever
  // the angle, and there is no couple.
  const double q = 1.1;
  const double side = 0.2 / std::sin(q);
  const Vec2 along{side, 0};
  const Vec2 across{side * std::cos(q), side * std::sin(q)};
  OverlapPolygon rhombus;
  rhombus.push(Vec2{0, 0}, {true, 0});
  rhombus.push(along, {false, 0});
  rhombus.push(along + across, {true, 0});
  rhombus.push(across, {false, 0});
  const PolygonMoments r = polygon_moments(rhombus);
  CHECK(r.depth == near_relative(0.2, 1e-14));
  CHECK(r.gradient.norm() <= 1e-14);
  CHECK(std::abs(r.rotation) <= 1e-14);
}

TEST_CASE("a polygon without an area has no depth") {
  OverlapPolygon line;
  line.push({0, 0}, {false, 0});
  line.push({1, 0}, {true, 0});
  line.push({2, 0}, {false, 0});
  CHECK(polygon_moments(line).depth == 0);
  CHECK(polygon_moments(line).gradient.norm() == 0);
}
