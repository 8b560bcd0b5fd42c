// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/convex_polygon.hpp>

#include <doctest/doctest.h>
#include <iterator>
#include <limits>
#include <type_traits>

#include <support/message_of.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

std::string complaint(std::vector<Vec2> vertices) {
  return message_of([&] { ConvexPolygon polygon(std::move(vertices)); });
}

std::vector<Vec2> vertices_of(const ConvexPolygon& polygon) {
  return {polygon.begin(), polygon.end()};
}

}  // namespace

static_assert(!std::is_default_constructible_v<ConvexPolygon>, "every polygon is a valid one");
static_assert(!std::is_convertible_v<std::vector<Vec2>, ConvexPolygon>);
static_assert(std::is_same_v<std::iterator_traits<ConvexPolygon::iterator>::reference, const Vec2&>,
              "vertices cannot be moved after the check");

TEST_CASE("a convex counter-clockwise ring is accepted as it was given") {
  const ConvexPolygon polygon{{0, 0}, {2, -1}, {3, 2}, {1, 3}};
  REQUIRE(polygon.size() == 4);
  CHECK(polygon[1].x() == 2);
  CHECK(polygon[1].y() == -1);
  CHECK(polygon.ring().size() == 4);
  CHECK(polygon.ring().data() == &polygon[0]);
  CHECK(std::distance(polygon.begin(), polygon.end()) == 4);
}

TEST_CASE("a polygon has 3 to 64 vertices") {
  CHECK(complaint({}) == "polygon has 0 vertices: must be 3 to 64");
  CHECK(complaint({{0, 0}, {1, 0}}) == "polygon has 2 vertices: must be 3 to 64");
  CHECK_NOTHROW((void)regular_polygon(3, 1));
  CHECK_NOTHROW((void)regular_polygon(64, 1));
  CHECK(message_of([] { (void)regular_polygon(65, 1); }) ==
        "polygon has 65 vertices: must be 3 to 64");
}

TEST_CASE("coordinates are finite") {
  constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(complaint({{0, 0}, {1, nan_value}, {0, 1}}) ==
        "polygon vertex 1 at (1, nan): coordinates must be finite");
  CHECK(complaint({{0, 0}, {1, 0}, {-infinity, 1}}) ==
        "polygon vertex 2 at (-inf, 1): coordinates must be finite");
}

TEST_CASE("a polygon whose areas would overflow or underflow is refused by its size") {
  for (const double size : {1e-200, 1e-71, 1e71, 1e160, 1e300}) {
    CAPTURE(size);
    CHECK(contains(complaint({{0, 0}, {size, 0}, {0, size}}), "must lie between 1e-70 and 1e70 m"));
  }
  for (const double size : {1e-60, 1e60}) CHECK(complaint({{0, 0}, {size, 0}, {0, size}}).empty());
}

TEST_CASE("a ring that breaks a rule makes no polygon") {
  CHECK(try_convex_polygon({{0, 0}, {1, 0}, {0, 1}}));
  CHECK_FALSE(try_convex_polygon({{0, 0}, {0, 1}, {1, 0}}));
  CHECK_FALSE(try_convex_polygon({{0, 0}, {1, 0}}));
}

TEST_CASE("a clockwise ring is refused, with the vertex, its place and the rule") {
  CHECK(complaint({{0, 0}, {0, 4}, {3, 0}}) ==
        "polygon vertex 2 at (3, 0) lies -3 m to the left of the edge from vertex 0 at (0, 0): "
        "must be above 5e-09 m (strictly convex, counter-clockwise)");
  for (std::size_t n : {3u, 4u, 7u, 64u}) {
    std::vector<Vec2> ring = vertices_of(regular_polygon(n, 1));
    CHECK(complaint(ring).empty());
    CHECK(contains(complaint({ring.rbegin(), ring.rend()}), "counter-clockwise"));
  }
}

TEST_CASE("a vertex on the line of an edge is refused") {
  const std::string middle = complaint({{0, 0}, {1, 0}, {2, 0}, {1, 1}});
  CHECK(contains(middle, "vertex 2 at (2, 0) lies 0 m to the left of the edge from vertex 0"));
  CHECK(contains(complaint({{0, 0}, {1, 1}, {2, 2}}), "strictly convex"));
}

TEST_CASE("a notch is refused and names the vertex before or after it") {
  // Vertex 3 lies inside: the edges at the notch have a neighbour on their right.
  const std::string text = complaint({{0, 0}, {2, 0}, {2, 2}, {1, 0.5}, {0, 2}});
  CHECK(contains(text, "strictly convex"));
  CHECK(contains(text, "vertex 2 at (2, 2)"));
}

TEST_CASE("vertices that fall together are refused") {
  CHECK(complaint({{1, 2}, {1, 2}, {1, 2}}) == "polygon has no extent: all vertices coincide");
  CHECK(complaint({{0, 0}, {1, 0}, {1, 0}, {0, 1}}) ==
        "polygon vertex 1 at (1, 0) coincides with vertex 2 at (1, 0): vertices must be distinct");
  // The last and the first are neighbours too: a closed ring is not an open one.
  CHECK(contains(complaint({{0, 0}, {1, 0}, {0, 1}, {0, 0}}), "coincides with vertex 0 at (0, 0)"));
  // Not neighbours: a figure of eight.
  CHECK(contains(complaint({{0, 0}, {1, 0}, {0, 0}, {0, 1}}), "strictly convex"));
}

TEST_CASE("a ring that winds twice is refused although it turns left at every vertex") {
  const std::vector<Vec2> pentagon = vertices_of(regular_polygon(5, 1));
  std::vector<Vec2> pentagram;
  for (std::size_t i = 0; i < 5; ++i) pentagram.push_back(pentagon[2 * i % 5]);
  for (std::size_t i = 0; i < 5; ++i) {
    const Vec2 in = pentagram[(i + 1) % 5] - pentagram[i];
    const Vec2 out = pentagram[(i + 2) % 5] - pentagram[(i + 1) % 5];
    REQUIRE(cross(in, out) > 0);
  }
  CHECK(contains(complaint(pentagram), "strictly convex, counter-clockwise"));
}

TEST_CASE("the rule is relative to the size, wherever the polygon lies") {
  // A flat triangle: its apex is 2e-9 or half of 1e-9 of the diameter above the base.
  for (const double size : {1e-6, 1.0, 1e6}) {
    CHECK(complaint({{0, 0}, {size, 0}, {0.5 * size, 2e-9 * size}}).empty());
    CHECK(contains(complaint({{0, 0}, {size, 0}, {0.5 * size, 0.5e-9 * size}}), "must be above"));
  }
  for (const double size : {1e-3, 1.0})
    for (const Pose& pose : poses(size)) CHECK_NOTHROW((void)pose.of(regular_polygon(64, size)));
}

TEST_CASE("a moved polygon is turned about the origin and then shifted") {
  const ConvexPolygon polygon{{1, 0}, {2, 0}, {1, 3}};
  const ConvexPolygon moved = polygon.moved(Rotation::from_angle(pi / 2), {10, 20});
  // One rounding of a coordinate near 20.
  CHECK((moved[0] - Vec2{10, 21}).norm() <= 4e-15);
  CHECK((moved[1] - Vec2{10, 22}).norm() <= 4e-15);
  CHECK((moved[2] - Vec2{7, 21}).norm() <= 4e-15);
}
