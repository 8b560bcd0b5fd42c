// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/ring_distance.hpp>

#include <doctest/doctest.h>

#include <vector>

using namespace riprap;

namespace {

// An L: the square of side 2 without its upper right quarter.
const std::vector<Vec2> l_shape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

}  // namespace

TEST_CASE("the nearest point of a segment is on it, or one of its ends") {
  CHECK(distance_to_segment({1, 2}, {0, 0}, {3, 0}) == 2);
  CHECK(distance_to_segment({6, 4}, {0, 0}, {3, 0}) == 5);
  CHECK(distance_to_segment({-3, -4}, {0, 0}, {3, 0}) == 5);
  CHECK(distance_to_segment({3, 4}, {0, 0}, {0, 0}) == 5);
}

TEST_CASE("the nearest edge of a ring, from inside and from outside") {
  CHECK(distance_to_ring({0.5, 1.5}, l_shape) == 0.5);
  CHECK(distance_to_ring({1.25, 0.5}, l_shape) == 0.5);
  CHECK(distance_to_ring({1.5, 1.75}, l_shape) == 0.5);
  CHECK(distance_to_ring({5, 5}, l_shape) == 5);
}

TEST_CASE("inside a concave ring, whichever way round") {
  std::vector<Vec2> ring = l_shape;
  for (int turn = 0; turn < 2; ++turn) {
    for (const Vec2& x : {Vec2{0.5, 0.5}, Vec2{1.5, 0.5}, Vec2{0.5, 1.5}, Vec2{0.999, 0.999}})
      CHECK(ring_contains(ring, x));
    for (const Vec2& x :
         {Vec2{1.5, 1.5}, Vec2{1.001, 1.001}, Vec2{-1, 0.5}, Vec2{3, 0.5}, Vec2{1.5, 3}})
      CHECK_FALSE(ring_contains(ring, x));
    ring = {ring.rbegin(), ring.rend()};
  }
}
