// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/outline.hpp>

#include <doctest/doctest.h>

#include <limits>
#include <string>
#include <vector>

#include <riprap/geometry/polygon_properties.hpp>
#include <support/message_of.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

std::string error_of(const std::vector<Vec2>& vertices) {
  return message_of([&] { (void)Outline(vertices); });
}

}  // namespace

TEST_CASE("a concave ring is taken either way round, closed or open, without straight vertices") {
  const std::vector<Vec2> l_shape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  CHECK(Outline(l_shape).ring().size() == 6);
  CHECK(polygon_area(Outline(l_shape).ring()) == 3);
  const std::vector<Vec2> clockwise(l_shape.rbegin(), l_shape.rend());
  CHECK(polygon_area(Outline(clockwise).ring()) == 3);
  std::vector<Vec2> more = l_shape;
  more.push_back(l_shape[0]);
  more.insert(more.begin() + 1, {{0.5, 0}, {0.75, 0}});
  more.insert(more.begin(), {0, 1});
  more.back() = {0, 1};  // begins and ends within an edge
  more.push_back({0, 0.5});
  more.erase(more.begin());
  REQUIRE(more.size() == 10);
  const Outline outline(more);
  REQUIRE(outline.ring().size() == 6);
  CHECK(polygon_area(outline.ring()) == 3);
}

TEST_CASE("rings that are no simple polygon are refused with the edges and the rule") {
  CHECK(contains(error_of({{0, 0}, {1, 0}}), "outline has 2 vertices: must be 3 or more"));
  CHECK(contains(error_of({{0, 0}, {1, 0}, {0, 0}}), "outline has 2 vertices"));
  CHECK(contains(error_of({{1, 1}, {1, 1}, {1, 1}, {1, 1}}), "no extent"));
  CHECK(contains(error_of({{0, 0}, {1, 1}, {3, 3}}), "outline lies on a line"));
  CHECK(contains(error_of({{0, 0}, {1, std::numeric_limits<double>::quiet_NaN()}, {3, 3}}),
                 "outline vertex 1 at (1, nan): coordinates must be finite"));
  // A bow tie.
  const std::string bow = error_of({{0, 0}, {1, 1}, {1, 0}, {0, 1}});
  CHECK(contains(bow, "edge from (0, 0) to (1, 1) meets the edge from (1, 0) to (0, 1)"));
  CHECK(contains(bow, "must not cross or touch"));
  // A vertex on another edge.
  CHECK(contains(error_of({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}), "meets the edge"));
  // A spike without width.
  CHECK(contains(error_of({{0, 0}, {2, 0}, {2, 2}, {2, 1}, {0, 1}}), "meets the edge"));
  // A square hole, joined to the ring by an edge there and back.
  CHECK(contains(
      error_of({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}}),
      "an outline has no holes"));
}

TEST_CASE("edges may come near each other, a thousand diameters from the origin too") {
  for (const Vec2& shift : {Vec2{0, 0}, Vec2{4000, -3000}}) {
    // A slot that is 1e-6 wide.
    std::vector<Vec2> slot{{0, 0}, {4, 0}, {4, 3}, {2.000001, 3}, {2, 1}, {2, 3}, {0, 3}};
    for (Vec2& v : slot) v += shift;
    CHECK(Outline(slot).ring().size() == 7);
    slot[3] = Vec2{2, 3} + shift;
    CHECK_THROWS_AS(Outline{slot}, InvalidInput);
  }
}
