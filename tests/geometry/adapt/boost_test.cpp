// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/adapt/boost.hpp>

// Boost 1.74 would round coordinates to a grid first; later versions never do.
#define BOOST_GEOMETRY_NO_ROBUSTNESS
#include <boost/geometry/algorithms/area.hpp>
#include <boost/geometry/algorithms/centroid.hpp>
#include <boost/geometry/algorithms/is_valid.hpp>
#include <boost/geometry/algorithms/within.hpp>
#include <boost/geometry/core/ring_type.hpp>
#include <boost/geometry/geometries/concepts/check.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <doctest/doctest.h>
#include <string>

#include <riprap/geometry/random_polygon.hpp>

#include <support/polygons.hpp>

namespace bg = boost::geometry;
using namespace riprap;
using namespace riprap::test;

static_assert(std::is_same_v<bg::tag<Vec2>::type, bg::point_tag>);
static_assert(bg::dimension<Vec2>::value == 2);
static_assert(std::is_same_v<bg::tag<ConvexPolygon>::type, bg::ring_tag>);
static_assert(std::is_same_v<bg::point_type<ConvexPolygon>::type, Vec2>);
static_assert(bg::point_order<ConvexPolygon>::value == bg::counterclockwise);
static_assert(bg::closure<ConvexPolygon>::value == bg::open);

TEST_CASE("Boost.Geometry's concepts hold: a point to write, a polygon to read") {
  bg::concepts::check<Vec2>();
  bg::concepts::check<const ConvexPolygon>();
  Vec2 v{1, 2};
  bg::set<0>(v, 3.0);
  bg::set<1>(v, 4.0);
  CHECK(v == Vec2{3, 4});
  CHECK(bg::get<0>(v) == 3);
  CHECK(bg::get<1>(v) == 4);
}

TEST_CASE("Boost.Geometry finds riprap's area and centroid, with the right sign") {
  Random random(21);
  for (int trial = 0; trial < 200; ++trial) {
    const ConvexPolygon polygon =
        shifted(random_polygon({.most_vertices = 10}, 1, random), {0.3, -0.8});
    const AreaProperties p = area_properties(polygon.ring());
    // Two summations of the same terms; a wrong order or closure changes sign or misses an edge.
    CHECK(std::abs(bg::area(polygon) - p.area) <= 4e-15);
    Vec2 centroid;
    bg::centroid(polygon, centroid);
    CHECK((centroid - p.centroid).norm() <= 1e-14);
  }
}

TEST_CASE("a convex polygon is valid to Boost.Geometry") {
  Random random(22);
  for (int trial = 0; trial < 200; ++trial) {
    std::string reason;
    const bool valid = bg::is_valid(random_polygon({.most_vertices = 64}, 1, random), reason);
    CHECK_MESSAGE(valid, reason);
  }
}

TEST_CASE("Boost.Geometry distinguishes inside from outside") {
  const ConvexPolygon square = unit_square();
  CHECK(bg::within(Vec2{0.5, 0.9}, square));
  CHECK(bg::within(Vec2{0.01, 0.5}, square));  // beside the edge that closes the ring
  CHECK_FALSE(bg::within(Vec2{-0.01, 0.5}, square));
  CHECK_FALSE(bg::within(Vec2{1, 0.5}, square));
}

TEST_CASE("Boost.Geometry reads the vertices where riprap stores them") {
  const ConvexPolygon square = unit_square();
  CHECK(&*boost::begin(square) == square.ring().data());
  CHECK(boost::size(square) == 4);
}
