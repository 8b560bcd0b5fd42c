// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/convex_hull.hpp>

#include <doctest/doctest.h>

#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/geometry/line_side.hpp>

using namespace riprap;

TEST_CASE("the hull of a few points") {
  const std::vector<Vec2> points{{1, 1}, {0, 0}, {2, 0}, {1, 0}, {2, 2}, {0, 2}, {0, 0}, {0, 1}};
  const std::vector<Vec2> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  CHECK(convex_hull(points) == square);
  CHECK(convex_hull(square) == square);
  CHECK(convex_hull(std::vector<Vec2>{{3, 1}, {1, 1}, {2, 1}}) ==
        std::vector<Vec2>{{1, 1}, {3, 1}});
  CHECK(convex_hull(std::vector<Vec2>{{3, 1}}).size() == 1);
  CHECK(convex_hull(std::vector<Vec2>{}).empty());
}

TEST_CASE("all points lie to the left of all edges, and corners are points") {
  Random random(1);
  for (int run = 0; run < 50; ++run) {
    std::vector<Vec2> points;
    for (int k = 0; k < 40; ++k) {
      const double x = random.uniform(-1, 1);
      points.push_back({x, random.uniform(-1, 1)});
    }
    const std::vector<Vec2> hull = convex_hull(points);
    for (std::size_t k = 0; k < hull.size(); ++k) {
      const LineSide edge(hull[k], hull[next_vertex(k, hull.size())]);
      for (const Vec2& p : points) CHECK(edge(p) >= -1e-15);
      CHECK(std::find(points.begin(), points.end(), hull[k]) != points.end());
    }
  }
}
