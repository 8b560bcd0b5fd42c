// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/corner_corner_overlap.hpp>

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

}  // namespace

TEST_CASE("a face over the end of another leaves a rectangle") {
  // The upper right corner of the one lies in the other, whose lower left corner lies in the one.
  const ConvexPolygon below{{-1, -1}, {1, -1}, {1, 0}, {-1, 0}};
  const ConvexPolygon above{{0.4, -0.1}, {2, -0.1}, {2, 1}, {0.4, 1}};
  const auto lens = corner_corner_overlap({below.ring(), above.ring(), 2, 0, margin});
  REQUIRE(lens);
  CHECK(lens->area == near_relative(0.6 * 0.1, 1e-15));
  CHECK((lens->leaves_a - Vec2{0.4, 0}).norm() <= 1e-15);
  CHECK((lens->enters_a - Vec2{1, -0.1}).norm() <= 1e-15);
  // The other way round the crossings change places.
  const auto swapped = corner_corner_overlap({above.ring(), below.ring(), 0, 2, margin});
  REQUIRE(swapped);
  CHECK(swapped->area == near_relative(0.06, 1e-15));
  CHECK((swapped->leaves_a - lens->enters_a).norm() <= 1e-15);
}

TEST_CASE("there is no lens at other corners, nor where rings are apart, flush or right through") {
  const ConvexPolygon below{{-1, -1}, {1, -1}, {1, 0}, {-1, 0}};
  const ConvexPolygon above{{0.4, -0.1}, {2, -0.1}, {2, 1}, {0.4, 1}};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      CHECK(corner_corner_overlap({below.ring(), above.ring(), i, j, margin}).has_value() ==
            (i == 2 && j == 0));
  const auto none = [&](const ConvexPolygon& other) {
    return !corner_corner_overlap({below.ring(), other.ring(), 2, 0, margin});
  };
  CHECK(none(ConvexPolygon{{0.4, 0.1}, {2, 0.1}, {2, 1}, {0.4, 1}}));
  CHECK(none(ConvexPolygon{{0.4, 0}, {2, 0}, {2, 1}, {0.4, 1}}));
  CHECK(none(ConvexPolygon{{0.4, -2}, {2, -2}, {2, 1}, {0.4, 1}}));
  CHECK(none(ConvexPolygon{{-3, -0.1}, {2, -0.1}, {2, 1}, {-3, 1}}));
}

TEST_CASE("where there is a lens, it is what clipping finds") {
  Random random(4);
  int lenses = 0;
  for (int n = 0; n < 3000; ++n) {
    const ConvexPolygon a = random_polygon({.most_vertices = 7}, 1, random);
    const double angle = random.uniform(0, 6.3);
    const double apart = random.uniform(0.5, 1.2);
    const ConvexPolygon b = random_polygon({.most_vertices = 7}, 1, random)
                                .moved({}, apart * Vec2{std::cos(angle), std::sin(angle)});
    for (std::size_t i = 0; i < a.size(); ++i)
      for (std::size_t j = 0; j < b.size(); ++j) {
        const auto lens = corner_corner_overlap({a.ring(), b.ring(), i, j, margin});
        if (!lens) continue;
        ++lenses;
        const OverlapPolygon common = overlap(a.ring(), b.ring(), {0, 0}, 0);
        CHECK(common.size == 4);
        CHECK(std::abs(lens->area - polygon_area(common.ring())) <= 1e-14);
        double nearest[2] = {1, 1};  // of its vertices to the crossings
        for (const Vec2& v : common.ring()) {
          nearest[0] = std::min(nearest[0], (v - lens->leaves_a).norm());
          nearest[1] = std::min(nearest[1], (v - lens->enters_a).norm());
        }
        // Where edges graze each other a crossing has fewer digits.
        CHECK(nearest[0] <= 1e-11);
        CHECK(nearest[1] <= 1e-11);
      }
  }
  CHECK(lenses > 200);
}
