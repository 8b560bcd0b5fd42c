// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/smoothed_outline.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <riprap/geometry/ring_distance.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

TEST_CASE("a circle shrinks by the fourth power of the width over its radius") {
  std::vector<Vec2> vertices;
  for (int k = 0; k < 2000; ++k)
    vertices.push_back(Rotation::from_angle(2 * pi * k / 2000) * Vec2{3, 0});
  // 100 points. Of their weights the fourth moment is -(3 / 35) 7 8 9 10 steps; the sixth adds a
  // hundredth of it here, and edges are 1e-6 inside the circle.
  const double step = 2 * pi / 100;
  const double share = 3.0 / 35 * 5040 * std::pow(step, 4) / 24;
  const Outline smoothed = smoothed_outline(Outline(vertices), 8 * 3 * step);
  for (const Vec2& v : smoothed.ring()) CHECK(v.norm() / 3 == near(1 - share, 0.02 * share));
}

TEST_CASE("straight sides stay where they are, and steps go") {
  const Outline square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  const Outline smoothed = smoothed_outline(square, 0.2);
  for (const Vec2& corner : square.ring()) CHECK(distance_to_ring(corner, smoothed.ring()) > 0.01);
  for (const double t : {0.21, 0.5, 0.79})
    for (const Vec2& p : {Vec2{t, 0}, Vec2{t, 1}, Vec2{0, t}, Vec2{1, t}})
      CHECK(distance_to_ring(p, smoothed.ring()) < 1e-14);
  // A staircase of 100 pixels along the diagonal of a triangle, which is off the middle of the
  // steps by 0.35 pixels.
  std::vector<Vec2> stairs{{0, 0}, {100, 0}};
  for (int k = 1; k <= 100; ++k) {
    stairs.push_back({100.0 - k + 1, static_cast<double>(k)});
    if (k < 100) stairs.push_back({100.0 - k, static_cast<double>(k)});
  }
  stairs.push_back({0, 100});
  const Outline slope = smoothed_outline(Outline(stairs), 8);
  for (const Vec2& v : slope.ring())
    if (std::min(v.x(), v.y()) > 10)
      CHECK((v.x() + v.y() - 100.5) / std::sqrt(2) == near(0, 0.35 / 8));
}

TEST_CASE("a width that smooths too much is refused") {
  const Outline square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
  for (const double width : {0.0, 1.01})
    CHECK(contains(message_of([&] { (void)smoothed_outline(square, width); }),
                   "must be above 0 and at most a quarter of the perimeter"));
}
