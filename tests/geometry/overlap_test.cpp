// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/overlap.hpp>

// Boost keeps boxes that are filled later; inlined, g++ takes them for forgotten.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
// Boost 1.74 would round coordinates to a grid first; later versions never do.
#define BOOST_GEOMETRY_NO_ROBUSTNESS
#include <boost/geometry/algorithms/area.hpp>
#include <boost/geometry/algorithms/intersection.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <doctest/doctest.h>
#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/geometry/adapt/boost.hpp>
#include <riprap/geometry/random_polygon.hpp>

#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

const Vec2 zero{0, 0};

OverlapPolygon common(const ConvexPolygon& a, const ConvexPolygon& b, double tolerance = 0) {
  return overlap(a.ring(), b.ring(), zero, tolerance);
}

double common_area(const ConvexPolygon& a, const ConvexPolygon& b) {
  return area_properties(common(a, b).ring()).area;
}

std::size_t edges_of_b(const OverlapPolygon& polygon) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < polygon.size; ++i) count += polygon.sources[i].of_b;
  return count;
}

double distance_from_edge(const Vec2& x, const ConvexPolygon& polygon, std::size_t edge) {
  const Vec2 p = polygon[edge];
  const Vec2 along = polygon[(edge + 1) % polygon.size()] - p;
  return std::abs(cross(along, x - p)) / along.norm();
}

/// Both ends of every edge lie on the line of the edge that is its source.
void check_sources(const OverlapPolygon& polygon, const ConvexPolygon& a, const ConvexPolygon& b,
                   double error) {
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const EdgeSource source = polygon.sources[i];
    const ConvexPolygon& owner = source.of_b ? b : a;
    REQUIRE(source.edge < owner.size());
    CHECK(distance_from_edge(polygon.vertices[i], owner, source.edge) <= error);
    const std::size_t next = (i + 1) % polygon.size;
    CHECK(distance_from_edge(polygon.vertices[next], owner, source.edge) <= error);
  }
}

struct Pair {
  ConvexPolygon a;
  ConvexPolygon b;
};

Pair random_pair(Random& random) {
  const PolygonShape shape{.most_vertices = 8};
  ConvexPolygon a = random_polygon(shape, random.uniform(0.5, 1.5), random);
  const ConvexPolygon b = random_polygon(shape, random.uniform(0.5, 1.5), random);
  const Vec2 offset{random.uniform(-0.8, 0.8), random.uniform(-0.8, 0.8)};
  return {std::move(a), shifted(b, offset)};
}

}  // namespace

TEST_CASE("a corner in an edge overlaps in a triangle") {
  // A corner of half angle t that is h deep: area h^2 tan t, base 2 h tan t.
  for (const double degrees : {15.0, 45.0, 70.0})
    for (const double h : {1e-6, 0.01, 0.3}) {
      const double slope = std::tan(degrees * pi / 180);
      const ConvexPolygon edge = rectangle(10, 2);
      const ConvexPolygon corner{{0.2, 1 - h}, {0.2 + slope, 2 - h}, {0.2 - slope, 2 - h}};
      for (const Pose& pose : poses(1)) {
        const ConvexPolygon a = pose.of(edge);
        const ConvexPolygon b = pose.of(corner);
        const OverlapPolygon triangle = overlap(a.ring(), b.ring(), a[0], 0);
        // Coordinates relative to a vertex nearby: their round-off is that of a position.
        const double error = 4e-15 * pose.digits;
        const double base = 2 * h * slope;
        REQUIRE(triangle.size == 3);
        CHECK(std::abs(area_properties(triangle.ring()).area - h * base / 2) <= error * base);
        CHECK(edges_of_b(triangle) == 2);
        for (std::size_t i = 0; i < 3; ++i) {
          if (triangle.sources[i].of_b) continue;
          CHECK(triangle.sources[i].edge == 2);
          const Vec2 chord = triangle.vertices[(i + 1) % 3] - triangle.vertices[i];
          CHECK(std::abs(chord.norm() - base) <= 2 * error * (1 + slope));
        }
      }
    }
}

TEST_CASE("offset squares overlap in a rectangle with two edges of each") {
  const ConvexPolygon a = unit_square();
  const ConvexPolygon b = shifted(unit_square(), {0.6, 0.7});
  const OverlapPolygon rectangle_of_both = common(a, b);
  REQUIRE(rectangle_of_both.size == 4);
  const AreaProperties p = area_properties(rectangle_of_both.ring());
  CHECK(std::abs(p.area - 0.4 * 0.3) <= 2e-16);
  CHECK((p.centroid - Vec2{0.8, 0.85}).norm() <= 4e-16);
  CHECK(edges_of_b(rectangle_of_both) == 2);
  check_sources(rectangle_of_both, a, b, 4e-16);
}

TEST_CASE("a polygon inside another is the overlap, with its own edges only") {
  const ConvexPolygon large = rectangle(10, 10);
  const ConvexPolygon small = shifted(regular_polygon(5, 1), {2, -1});
  const double area = area_properties(small.ring()).area;
  const OverlapPolygon second = common(large, small);
  CHECK(second.size == 5);
  CHECK(edges_of_b(second) == 5);
  CHECK(std::abs(area_properties(second.ring()).area - area) <= 1e-14);
  check_sources(second, large, small, 1e-14);
  const OverlapPolygon first = common(small, large);
  CHECK(first.size == 5);
  CHECK(edges_of_b(first) == 0);
  CHECK(std::abs(area_properties(first.ring()).area - area) <= 1e-14);
  check_sources(first, small, large, 1e-14);
}

TEST_CASE("two squares across each other overlap in an octagon with edges in turn") {
  // Two concentric unit squares, one turned by 45 degrees: a regular octagon of inradius 1/2,
  // of area 2 (sqrt 2 - 1).
  for (const Pose& pose : poses(1)) {
    const ConvexPolygon a = pose.of(rectangle(1, 1));
    const ConvexPolygon b = pose.of(rectangle(1, 1).moved(Rotation::from_angle(pi / 4), {0, 0}));
    const OverlapPolygon octagon = common(a, b);
    REQUIRE(octagon.size == 8);
    const double error = 4e-15 * pose.digits;
    CHECK(std::abs(area_properties(octagon.ring()).area - 2 * (std::sqrt(2.0) - 1)) <= error);
    for (std::size_t i = 0; i < 8; ++i) {
      CHECK(octagon.sources[i].of_b != octagon.sources[(i + 1) % 8].of_b);
      const Vec2 edge = octagon.vertices[(i + 1) % 8] - octagon.vertices[i];
      CHECK(std::abs(edge.norm() - (std::sqrt(2.0) - 1)) <= error);
    }
    check_sources(octagon, a, b, error);
  }
}

TEST_CASE("two rings of 64 vertices may overlap in one of 128") {
  const ConvexPolygon a = regular_polygon(64, 1);
  const ConvexPolygon b = regular_polygon(64, 1, pi / 64);
  const OverlapPolygon both = common(a, b);
  REQUIRE(both.size == 128);
  CHECK(edges_of_b(both) == 64);
  // A regular 128-gon with the inradius of both: n r^2 tan(pi / n).
  const double inradius = std::cos(pi / 64);
  const double expected = 128 * inradius * inradius * std::tan(pi / 128);
  CHECK(std::abs(area_properties(both.ring()).area - expected) <= 1e-14);
}

TEST_CASE("a polygon overlaps with itself in itself") {
  for (const std::size_t n : {3u, 4u, 17u})
    for (const Pose& pose : poses(1)) {
      const ConvexPolygon a = pose.of(regular_polygon(n, 1));
      const double area = area_properties(a.ring()).area;
      CHECK(std::abs(common_area(a, a) - area) <= 4e-15 * pose.digits);
      CHECK(std::abs(common_area(a, begun_at(a, 2)) - area) <= 4e-15 * pose.digits);
    }
}

TEST_CASE("polygons that are apart or only touch have no overlap") {
  const ConvexPolygon a = unit_square();
  CHECK(common(a, shifted(a, {1.2, 0})).size == 0);
  CHECK(common(a, shifted(a, {0, -7})).size == 0);
  CHECK(common(a, shifted(a, {1, 0.3}), 1e-9).size == 0);
  CHECK(common(a, shifted(a, {1, 1}), 1e-9).size == 0);
  CHECK(common(a, shifted(a, {1, 0}), 1e-9).size == 0);
}

TEST_CASE("the overlap is given relative to the origin asked for") {
  const Vec2 far{3000, -4000};
  const ConvexPolygon a = shifted(unit_square(), far);
  const ConvexPolygon b = shifted(unit_square(), far + Vec2{0.5, 0.5});
  const AreaProperties p = area_properties(overlap(a.ring(), b.ring(), far, 0).ring());
  // Halves are exact.
  CHECK(p.area == 0.25);
  CHECK(p.centroid == Vec2{0.75, 0.75});
}

TEST_CASE("an edge shorter than the tolerance is dropped and the rest keeps its sources") {
  // The turned square cuts off the corner (1, 1) by an edge of 1.4e-6.
  const ConvexPolygon a = unit_square();
  const double reach = std::sqrt(0.5) * (2 - 1e-6);
  const ConvexPolygon b = rectangle(2 * reach, 2 * reach).moved(Rotation::from_angle(pi / 4), zero);
  const OverlapPolygon fine = common(a, b, 1e-7);
  CHECK(fine.size == 5);
  CHECK(edges_of_b(fine) == 1);
  const OverlapPolygon coarse = common(a, b, 1e-5);
  REQUIRE(coarse.size == 4);
  CHECK(edges_of_b(coarse) == 0);
  for (std::size_t i = 0; i < 4; ++i) CHECK_FALSE(coarse.sources[i] == coarse.sources[(i + 1) % 4]);
  // What is lost is at most the tolerance times the perimeter.
  CHECK(std::abs(area_properties(coarse.ring()).area - 1) <= 4e-5);
}

TEST_CASE("random pairs have the common area that Boost.Geometry finds") {
  namespace bg = boost::geometry;
  using BoostPolygon = bg::model::polygon<Vec2, false, false>;
  Random random(99);
  int overlapping = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    const Pair p = random_pair(random);
    std::vector<BoostPolygon> parts;
    bg::intersection(p.a, p.b, parts);
    double expected = 0;
    for (const BoostPolygon& part : parts) expected += bg::area(part);
    overlapping += expected > 0;
    // Crossings of nearly parallel edges lose digits, in Boost as here.
    CHECK(std::abs(common_area(p.a, p.b) - expected) <= 1e-12);
  }
  CHECK(overlapping > 500);
}

TEST_CASE("the overlap is convex, lies in both polygons and names the edges it is made of") {
  Random random(100);
  for (int trial = 0; trial < 300; ++trial) {
    const Pair p = random_pair(random);
    const OverlapPolygon both = common(p.a, p.b, 1e-9);
    // Round-off of a crossing is that of a coordinate over the sine of the crossing angle; dropped
    // edges move a vertex by the tolerance.
    check_sources(both, p.a, p.b, 2e-9);
    for (std::size_t i = 0; i < both.size; ++i)
      for (const ConvexPolygon* polygon : {&p.a, &p.b})
        for (std::size_t k = 0; k < polygon->size(); ++k) {
          const Vec2 edge = (*polygon)[(k + 1) % polygon->size()] - (*polygon)[k];
          CHECK(cross(edge, both.vertices[i] - (*polygon)[k]) >= -4e-15);
        }
    if (area_properties(both.ring()).area > 1e-3)
      CHECK_NOTHROW(ConvexPolygon{std::vector<Vec2>(both.ring().begin(), both.ring().end())});
  }
}

TEST_CASE("the overlap does not depend on the order, the pose, the mirror or the first vertex") {
  Random random(101);
  for (int trial = 0; trial < 300; ++trial) {
    const Pair p = random_pair(random);
    const OverlapPolygon ab = common(p.a, p.b);
    const AreaProperties expected = area_properties(ab.ring());
    const auto same = [&](const ConvexPolygon& a, const ConvexPolygon& b, double digits) {
      CHECK(std::abs(common_area(a, b) - expected.area) <= 4e-15 * digits);
    };
    same(p.b, p.a, 1);
    same(mirrored(p.a), mirrored(p.b), 1);
    same(begun_at(p.a, 2), begun_at(p.b, 1), 1);
    for (const Pose& pose : poses(1)) same(pose.of(p.a), pose.of(p.b), pose.digits);
    const OverlapPolygon ba = common(p.b, p.a);
    CHECK(ba.size == ab.size);
    CHECK(edges_of_b(ba) == ab.size - edges_of_b(ab));
  }
}

TEST_CASE("in other units of length the overlap is the same") {
  Random random(102);
  for (int trial = 0; trial < 50; ++trial) {
    const Pair p = random_pair(random);
    // A power of two leaves every digit as it is.
    const double f = std::ldexp(1.0, -30);
    CHECK(common_area(scaled(p.a, f), scaled(p.b, f)) == f * f * common_area(p.a, p.b));
  }
}
