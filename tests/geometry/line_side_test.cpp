// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/line_side.hpp>

#include <doctest/doctest.h>

#include <riprap/core/random.hpp>
#include <riprap/geometry/random_polygon.hpp>

using namespace riprap;

TEST_CASE("a point lies to a line at its distance, to the left, times the length") {
  const LineSide line({1, 1}, {1, 5});  // upwards
  CHECK(line({-2, 7}) == 3 * 4);
  CHECK(line({2, 7}) == -1 * 4);
  CHECK(line.along({-2, 7}) == 6 * 4);
  CHECK(line.length_bound() == 4);
  CHECK(line.lies_left_by({0.5, 0}, 0.49));
  CHECK(!line.lies_left_by({0.5, 0}, 0.51));
}

TEST_CASE("vertices of a ring come after each other, the first after the last") {
  CHECK(next_vertex(0, 3) == 1);
  CHECK(next_vertex(2, 3) == 0);
  CHECK(previous_vertex(0, 3) == 2);
  CHECK(previous_vertex(2, 3) == 1);
}

TEST_CASE("a point is inside the other edges if it is so for each of them") {
  Random random(2);
  int inside = 0;
  int outside = 0;
  for (int n = 0; n < 2000; ++n) {
    const ConvexPolygon ring = random_polygon({.most_vertices = 8}, 1, random);
    const Vec2 v{random.uniform(-0.7, 0.7), random.uniform(-0.7, 0.7)};
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (cross(ring[next_vertex(i, ring.size())] - ring[i], v - ring[i]) <= 0) continue;
      bool expected = true;
      for (std::size_t j = 0; j < ring.size(); ++j)
        if (j != i) expected &= cross(ring[next_vertex(j, ring.size())] - ring[j], v - ring[j]) > 0;
      CHECK(inside_other_edges(ring.ring(), i, v, 0) == expected);
      ++(expected ? inside : outside);
    }
  }
  CHECK(inside > 500);
  CHECK(outside > 500);
}
