// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/separation.hpp>

#include <doctest/doctest.h>

#include <riprap/core/random.hpp>
#include <riprap/geometry/random_polygon.hpp>

#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

bool apart(const ConvexPolygon& a, const ConvexPolygon& b) {
  SeparatingEdge cache;
  return separated(a.ring(), b.ring(), cache);
}

struct Pair {
  ConvexPolygon a;
  ConvexPolygon b;
};

/// Two polygons of diameter 0.5 to 1.5 with centroids up to `distance` apart.
Pair random_pair(Random& random, double distance) {
  const PolygonShape shape{.most_vertices = 7};
  ConvexPolygon a = random_polygon(shape, random.uniform(0.5, 1.5), random);
  const ConvexPolygon b = random_polygon(shape, random.uniform(0.5, 1.5), random);
  const Rotation direction = Rotation::from_angle(random.uniform(0, 2 * pi));
  return {std::move(a), shifted(b, direction * Vec2{random.uniform(0, distance), 0})};
}

}  // namespace

TEST_CASE("an edge separates what lies strictly outside it") {
  const ConvexPolygon square = unit_square();
  const ConvexPolygon right = shifted(square, {1.5, 0.2});
  CHECK_FALSE(edge_separates(square.ring(), 0, right.ring()));
  CHECK(edge_separates(square.ring(), 1, right.ring()));
  CHECK_FALSE(edge_separates(square.ring(), 2, right.ring()));
  CHECK_FALSE(edge_separates(square.ring(), 3, right.ring()));
  CHECK(edge_separates(right.ring(), 3, square.ring()));
  // Touching is not apart.
  CHECK_FALSE(edge_separates(square.ring(), 1, shifted(square, {1, 0.2}).ring()));
  CHECK_FALSE(apart(square, shifted(square, {1, 0.2})));
  CHECK_FALSE(apart(square, shifted(square, {1, 1})));
}

TEST_CASE("two shapes a corner apart need an edge of the right one of them") {
  // The corner of b points at the edge of a, and the other way round.
  const ConvexPolygon square = rectangle(2, 2);
  const ConvexPolygon diamond = regular_polygon(4, 1);
  SeparatingEdge cache;
  CHECK(separated(square.ring(), shifted(diamond, {2.01, 0}).ring(), cache));
  CHECK_FALSE(cache.of_b);
  CHECK(cache.edge == 1);
  // Along the diagonal only an edge of the diamond parts them.
  cache = {};
  CHECK(separated(square.ring(), shifted(diamond, {1.51, 1.51}).ring(), cache));
  CHECK(cache.of_b);
  CHECK(cache.edge == 2);
}

TEST_CASE("a cached edge never changes the result") {
  Random random(31);
  int count_apart = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Pair p = random_pair(random, 2);
    const bool expected = apart(p.a, p.b);
    count_apart += expected;
    for (const bool of_b : {false, true})
      for (const unsigned edge : {0u, 1u, 2u, 3u, 6u, 7u, 200u, 255u}) {
        SeparatingEdge cache{of_b, static_cast<std::uint8_t>(edge)};
        REQUIRE(separated(p.a.ring(), p.b.ring(), cache) == expected);
        if (!expected) continue;
        // What is remembered now does part them.
        CHECK((cache.of_b ? edge_separates(p.b.ring(), cache.edge, p.a.ring())
                          : edge_separates(p.a.ring(), cache.edge, p.b.ring())));
      }
  }
  // Both answers were asked for.
  CHECK(count_apart > 50);
  CHECK(count_apart < 250);
}

TEST_CASE("an edge that still separates is kept") {
  const ConvexPolygon square = unit_square();
  const ConvexPolygon corner = shifted(square, {1.5, 1.5});
  SeparatingEdge cache{true, 0};
  CHECK(separated(square.ring(), corner.ring(), cache));
  CHECK(cache.of_b);
  CHECK(cache.edge == 0);
}

TEST_CASE("separation does not depend on the order of the two nor on the pose") {
  Random random(8);
  for (int trial = 0; trial < 200; ++trial) {
    const Pair p = random_pair(random, 2);
    // Nearer to touching than this, round-off of the pose decides.
    const double depth = minimum_translation(p.a.ring(), p.b.ring()).depth;
    if (std::abs(depth) < 1e-11) continue;
    const bool expected = apart(p.a, p.b);
    CHECK(expected == (depth < 0));
    CHECK(apart(p.b, p.a) == expected);
    CHECK(apart(mirrored(p.a), mirrored(p.b)) == expected);
    CHECK(apart(begun_at(p.a, 1), begun_at(p.b, 2)) == expected);
    for (const Pose& pose : poses(1)) CHECK(apart(pose.of(p.a), pose.of(p.b)) == expected);
  }
}

TEST_CASE("offset squares have the smaller of their two overlaps as depth") {
  for (const Pose& pose : poses(1)) {
    const ConvexPolygon a = pose.of(unit_square());
    const ConvexPolygon b = pose.of(shifted(unit_square(), {0.7, 0.2}));
    const MinimumTranslation ab = minimum_translation(a.ring(), b.ring());
    const double error = 1e-15 * pose.digits;
    CHECK(std::abs(ab.depth - 0.3) <= error);
    CHECK((ab.normal - pose.rotation * Vec2{1, 0}).norm() <= error);
    const MinimumTranslation ba = minimum_translation(b.ring(), a.ring());
    CHECK(std::abs(ba.depth - 0.3) <= error);
    CHECK((ba.normal - pose.rotation * Vec2{-1, 0}).norm() <= error);
  }
}

TEST_CASE("a corner in an edge is pushed out across the edge, whichever of the two owns it") {
  const ConvexPolygon block = rectangle(4, 2);
  const ConvexPolygon diamond = shifted(regular_polygon(4, 0.5), {0.3, 1.5 - 0.02});
  const MinimumTranslation out = minimum_translation(block.ring(), diamond.ring());
  CHECK(std::abs(out.depth - 0.02) <= 1e-15);
  CHECK((out.normal - Vec2{0, 1}).norm() <= 1e-15);
  const MinimumTranslation back = minimum_translation(diamond.ring(), block.ring());
  CHECK(std::abs(back.depth - 0.02) <= 1e-15);
  CHECK((back.normal - Vec2{0, -1}).norm() <= 1e-15);
}

TEST_CASE("a small square inside a large one leaves by the nearest side") {
  const ConvexPolygon large = rectangle(10, 10);
  const ConvexPolygon small = shifted(rectangle(1, 1), {-3, 2});
  const MinimumTranslation out = minimum_translation(large.ring(), small.ring());
  CHECK(out.depth == near_relative(2.5, 1e-15));
  CHECK((out.normal - Vec2{-1, 0}).norm() <= 1e-15);
}

TEST_CASE("squares half a size apart have a depth of minus a half") {
  const MinimumTranslation gap =
      minimum_translation(unit_square().ring(), shifted(unit_square(), {0.1, 1.5}).ring());
  CHECK(gap.depth == -0.5);
  CHECK((gap.normal - Vec2{0, 1}).norm() == 0);
}

TEST_CASE("the minimum translation just parts two polygons, and no shorter one does") {
  Random random(12);
  int overlapping = 0;
  for (int trial = 0; trial < 200; ++trial) {
    const Pair p = random_pair(random, 1.2);
    const MinimumTranslation t = minimum_translation(p.a.ring(), p.b.ring());
    CHECK(std::abs(t.normal.norm() - 1) <= 4e-16);
    if (t.depth <= 0) continue;
    ++overlapping;
    // Round-off of coordinates of size one.
    constexpr double little = 1e-14;
    CHECK(apart(p.a, shifted(p.b, (t.depth + little) * t.normal)));
    CHECK_FALSE(apart(p.a, shifted(p.b, (t.depth - little) * t.normal)));
    for (int degrees = 0; degrees < 360; degrees += 3) {
      const Vec2 direction = Rotation::from_angle(degrees * pi / 180) * Vec2{1, 0};
      CHECK_FALSE(apart(p.a, shifted(p.b, (t.depth - little) * direction)));
    }
  }
  CHECK(overlapping > 100);
}
