// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/narrow_phase/common_part.hpp>

#include <doctest/doctest.h>

#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using test::near_relative;
using test::rectangle;

TEST_CASE("the common part of two rectangles lies relative to the first vertex of the first") {
  const ConvexPolygon a = rectangle({1, 1}, 2, 2);
  const ConvexPolygon b = rectangle({2, 1.75}, 1, 1);
  const CommonPart common = common_part(a.ring(), b.ring());
  CHECK(!common.empty());
  CHECK(common.area == near_relative(0.5 * 0.75, 1e-15));
  CHECK((a[0] + area_properties(common.polygon.ring()).centroid - Vec2{1.75, 1.625}).norm() <=
        1e-15);
  // A factor of two or so about the diameter of 2.8.
  CHECK(common.size > 1.4);
  CHECK(common.size < 5.7);
}

TEST_CASE("bodies apart, or with a sliver in common that round-off could make, have nothing") {
  const ConvexPolygon a = rectangle({0, 0}, 1, 1);
  CHECK(common_part(a.ring(), rectangle({3, 0}, 1, 1).ring()).empty());
  CHECK(common_part(a.ring(), rectangle({1, 1}, 1, 1).ring()).empty());
  CHECK(common_part(a.ring(), rectangle({1 - 1e-13, 0}, 1, 1).ring()).empty());
  CHECK(!common_part(a.ring(), rectangle({1 - 1e-8, 0}, 1, 1).ring()).empty());
}
