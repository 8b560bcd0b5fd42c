// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/corner_edge_overlap.hpp>

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/geometry/overlap.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using test::near_relative;
using test::rectangle;

namespace {

constexpr double margin = 4 * 1e-8;  // of the floor's edge

// At the upper edge of the floor, where the first vertices of the other ring are.
std::optional<CornerEdgeOverlap> cap_of(const ConvexPolygon& floor, const ConvexPolygon& other,
                                        std::uint8_t count = 1) {
  return corner_edge_overlap(floor.ring(), other.ring(),
                             corner_edge_feature(floor.size(), 2, other.size(), 0, count));
}

// The only edge of an overlap that is a's.
std::pair<Vec2, Vec2> edge_of_a(const OverlapPolygon& common) {
  std::size_t i = 0;
  while (common.sources[i].of_b) ++i;
  return {common.vertices[i], common.vertices[next_vertex(i, common.size)]};
}

const ConvexPolygon floor_below = rectangle({0, -1}, 4, 2);

}  // namespace

TEST_CASE("a tip in an edge leaves a triangle") {
  const ConvexPolygon tip{{0.5, -0.25}, {1.5, 0.75}, {-0.5, 0.75}};  // sides at 45 degrees
  const auto cap = cap_of(floor_below, tip);
  REQUIRE(cap);
  CHECK(cap->depth == near_relative(0.25, 1e-15));
  CHECK(cap->chord == near_relative(0.5, 1e-15));
  CHECK(cap->area == near_relative(0.0625, 1e-15));
  CHECK((cap->normal - Vec2{0, 1}).norm() <= 1e-15);
  CHECK((cap->middle - Vec2{0.5, 0}).norm() <= 1e-15);
}

TEST_CASE("a tilted face in an edge leaves a quadrangle") {
  const ConvexPolygon block{{-1, -0.1}, {1, -0.3}, {1, 1}, {-1, 1}};
  const auto cap = cap_of(floor_below, block, 2);
  REQUIRE(cap);
  CHECK(cap->depth == near_relative(0.3, 1e-15));
  CHECK(cap->chord == near_relative(2, 1e-15));
  CHECK(cap->area == near_relative(2 * 0.2, 1e-15));
  CHECK(!cap_of(floor_below, block, 1));  // there is another vertex inside
}

TEST_CASE("there is no cap where more than one edge is crossed or none") {
  const auto none = [](const ConvexPolygon& other, std::uint8_t count = 1) {
    return !cap_of(floor_below, other, count);
  };
  CHECK(none(ConvexPolygon{{0, 0.1}, {1, 1}, {-1, 1}}));             // apart
  CHECK(none(ConvexPolygon{{2.1, -0.25}, {3, 0.75}, {1.1, 0.75}}));  // the tip beside the end
  CHECK(none(ConvexPolygon{{1.9, -0.25}, {3, 0.75}, {1, 0.75}}));    // a crossing beside the end
  CHECK(none(ConvexPolygon{{0, -3}, {3, 4}, {-3, 4}}));              // right through
  CHECK(none(rectangle({0, 0.5}, 1, 1), 2));                         // flush
  CHECK(none(rectangle({1.8, 0.4}, 1, 1), 2));                       // over the end
}

TEST_CASE("what is next to round-off is left to others") {
  const auto tip = [](double x, double depth) {
    return ConvexPolygon{{x, -depth}, {x + 1, 1 - depth}, {x - 1, 1 - depth}};
  };
  CHECK(cap_of(floor_below, tip(0, 2.1 * margin)));
  CHECK(!cap_of(floor_below, tip(0, 0.9 * margin)));
  CHECK(cap_of(floor_below, tip(1.9 - 2 * margin, 0.1)));
  CHECK(!cap_of(floor_below, tip(1.9, 0.1)));
}

TEST_CASE("where there is a cap, it is what clipping finds") {
  // Clipping multiplies and divides the same numbers in another order, some ten times.
  Random random(3);
  int caps[2] = {0, 0};
  for (int n = 0; n < 3000; ++n) {
    const ConvexPolygon a = random_polygon({.most_vertices = 7}, 1, random);
    const double angle = random.uniform(0, 6.3);
    const double apart = random.uniform(0.7, 1.3);
    const ConvexPolygon b = random_polygon({.most_vertices = 7}, 1, random)
                                .moved({}, apart * Vec2{std::cos(angle), std::sin(angle)});
    for (std::uint8_t i = 0; i < a.size(); ++i)
      for (std::uint8_t first = 0; first < b.size(); ++first)
        for (const std::uint8_t count : {std::uint8_t{1}, std::uint8_t{2}}) {
          const auto cap = corner_edge_overlap(
              a.ring(), b.ring(), corner_edge_feature(a.size(), i, b.size(), first, count));
          if (!cap) continue;
          ++caps[count - 1];
          const OverlapPolygon common = overlap(a.ring(), b.ring(), {0, 0}, 0);
          CHECK(common.size == count + 2U);
          CHECK(std::abs(cap->area - polygon_area(common.ring())) <= 1e-14);
          CHECK(std::abs(cap->depth - extent_along(common.ring(), cap->normal)) <= 1e-14);
          const auto [from, to] = edge_of_a(common);
          CHECK(std::abs(cap->chord - (to - from).norm()) <= 1e-14);
          CHECK((cap->middle - 0.5 * (from + to)).norm() <= 1e-14);
        }
  }
  CHECK(caps[0] > 200);
  CHECK(caps[1] > 20);
}

namespace {

bool same_bits(const CornerEdgeOverlap& p, const CornerEdgeOverlap& q) {
  return p.normal == q.normal && p.middle == q.middle && p.depth == q.depth && p.area == q.area &&
         p.chord == q.chord && p.one_vertex == q.one_vertex;
}

// Tips and faces that dip into the floor, beside it or not at all.
struct Entering {
  ConvexPolygon polygon;
  CornerEdgeFeature place;
};
Entering random_entering(Random& random) {
  const auto count = random.uniform_integer(1, 2);
  const Vec2 to{random.uniform(-2, 2), random.uniform(-0.3, 0.1)};
  const Rotation turn = Rotation::from_angle(random.uniform(-0.4, 0.4));
  const ConvexPolygon polygon =
      count == 1 ? ConvexPolygon{{0, 0}, {1, 1}, {-1, 1}} : ConvexPolygon{{-1, 0}, {1, 0}, {0, 1}};
  return {polygon.moved(turn, to),
          corner_edge_feature(floor_below.size(), 2, polygon.size(), 0, count)};
}

template <std::size_t lanes>
std::size_t compare_with_scalar() {
  Random random(3);
  std::size_t found = 0;
  for (int k = 0; k < 2000; ++k) {
    std::vector<Entering> entering;
    for (int l = 0; l < 4; ++l) entering.push_back(random_entering(random));
    std::array<CornerEdgeQuery, 4> queries;
    for (std::size_t l = 0; l < 4; ++l)
      queries[l] = {floor_below.ring().data(), entering[l].polygon.ring().data(),
                    &entering[l].place};
    std::array<std::optional<CornerEdgeOverlap>, 4> several;
    find_corner_edge_overlaps<lanes>(
        queries, [&](std::size_t l, const CornerEdgeOverlap& one) { several[l] = one; });
    for (std::size_t l = 0; l < 4; ++l) {
      const auto alone =
          corner_edge_overlap(floor_below.ring(), entering[l].polygon.ring(), entering[l].place);
      REQUIRE(several[l].has_value() == alone.has_value());
      if (!alone) continue;
      ++found;
      CHECK(same_bits(*several[l], *alone));
    }
  }
  return found;
}

}  // namespace

TEST_CASE("overlaps found several at a time are those of the scalar formula, to the last bit") {
  CHECK(compare_with_scalar<2>() > 1000);
  CHECK(compare_with_scalar<native_lanes>() > 1000);
}
