#include <riprap/geometry/edge_cap.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/core/random.hpp>
#include <riprap/geometry/overlap.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using test::near_relative;
using test::rectangle;

namespace {

constexpr double margin = 1e-8;
constexpr std::size_t upper = 2;  // edge of a rectangle

std::optional<EdgeCap> cap_of(const ConvexPolygon& a, std::size_t i, const ConvexPolygon& b) {
  return edge_cap(a.ring(), i, b.ring(), edge_side(a.ring(), i, b.ring()), margin);
}

}  // namespace

TEST_CASE("a tip in an edge leaves a triangle") {
  const ConvexPolygon floor = rectangle({0, -1}, 4, 2);
  const ConvexPolygon tip{{0.5, -0.25}, {1.5, 0.75}, {-0.5, 0.75}};  // sides at 45 degrees
  const auto cap = cap_of(floor, upper, tip);
  REQUIRE(cap);
  CHECK(cap->depth == near_relative(0.25, 1e-15));
  CHECK(cap->chord == near_relative(0.5, 1e-15));
  CHECK(cap->area == near_relative(0.0625, 1e-15));
  CHECK((cap->normal - Vec2{0, 1}).norm() <= 1e-15);
  CHECK((cap->entry - Vec2{0.25, 0}).norm() <= 1e-15);
  CHECK((cap->exit - Vec2{0.75, 0}).norm() <= 1e-15);
}

TEST_CASE("a tilted face in an edge leaves a quadrangle") {
  const ConvexPolygon floor = rectangle({0, -1}, 4, 2);
  const ConvexPolygon block{{-1, -0.1}, {1, -0.3}, {1, 1}, {-1, 1}};
  const auto cap = cap_of(floor, upper, block);
  REQUIRE(cap);
  CHECK(cap->depth == near_relative(0.3, 1e-15));
  CHECK(cap->chord == near_relative(2, 1e-15));
  CHECK(cap->area == near_relative(2 * 0.2, 1e-15));
}

TEST_CASE("there is no cap where more than one edge is crossed or none") {
  const ConvexPolygon floor = rectangle({0, -1}, 4, 2);
  const auto none = [&](const ConvexPolygon& other) { return !cap_of(floor, upper, other); };
  CHECK(none(rectangle({0, 1}, 1, 1)));                              // apart
  CHECK(none(rectangle({0, -1}, 1, 1)));                             // inside
  CHECK(none(rectangle({2, 0.3}, 1, 1)));                            // over the end
  CHECK(none(ConvexPolygon{{2.1, -0.25}, {3, 0.75}, {1.1, 0.75}}));  // the tip beside the end
  CHECK(none(ConvexPolygon{{0, -3}, {3, 4}, {-3, 4}}));              // right through
  CHECK(none(rectangle({0, 0.5}, 1, 1)));                            // flush
}

TEST_CASE("what is next to round-off is left to others") {
  const ConvexPolygon floor = rectangle({0, -1}, 4, 2);
  const auto tip = [](double x, double depth) {
    return ConvexPolygon{{x, -depth}, {x + 1, 1 - depth}, {x - 1, 1 - depth}};
  };
  CHECK(cap_of(floor, upper, tip(0, 2.1 * margin)));
  CHECK(!cap_of(floor, upper, tip(0, 0.9 * margin)));
  CHECK(cap_of(floor, upper, tip(1.9 - 2 * margin, 0.1)));
  CHECK(!cap_of(floor, upper, tip(1.9, 0.1)));
}

TEST_CASE("where there is a cap, it is what clipping finds") {
  // Clipping multiplies and divides the same numbers in another order, some ten times.
  Random random(3);
  int caps = 0;
  for (int n = 0; n < 6000; ++n) {
    const ConvexPolygon a = random_polygon({.most_vertices = 7}, 1, random);
    const double angle = random.uniform(0, 6.3);
    const double apart = random.uniform(0.5, 1.3);
    const ConvexPolygon b = random_polygon({.most_vertices = 7}, 1, random)
                                .moved({}, apart * Vec2{std::cos(angle), std::sin(angle)});
    for (std::size_t i = 0; i < a.size(); ++i) {
      const auto cap = cap_of(a, i, b);
      if (!cap) continue;
      ++caps;
      const OverlapPolygon common = overlap(a.ring(), b.ring(), {0, 0}, 0);
      CHECK(std::abs(cap->area - polygon_area(common.ring())) <= 1e-14);
      CHECK(std::abs(cap->depth - extent_along(common.ring(), cap->normal)) <= 1e-14);
      CHECK(std::abs(cap->chord - (cap->entry - cap->exit).norm()) <= 1e-14);
    }
  }
  CHECK(caps > 500);
}
