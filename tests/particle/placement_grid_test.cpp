// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/placement_grid.hpp>

#include <doctest/doctest.h>

#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using namespace riprap::internal;
using test::near_relative;
using test::rectangle;

TEST_CASE("a place is clear where no placed polygon overlaps, also across cells and far away") {
  PlacementGrid grid(2);
  const ConvexPolygon placed = rectangle({1.9, 0}, 1, 1);
  grid.insert(placed, {1.9, 0});
  CHECK_FALSE(grid.is_clear(rectangle({2.5, 0.3}, 1, 1).ring(), {2.5, 0.3}));  // in the next cell
  CHECK(grid.is_clear(rectangle({3.0, 0}, 1, 1).ring(), {3.0, 0}));
  CHECK(grid.is_clear(rectangle({-700, 900}, 1, 1).ring(), {-700, 900}));
}

TEST_CASE("polygons have the sizes that are given, or sizes in the range of the options") {
  RandomAssembly options{.count = 40};
  CHECK(mean_diameter(options) == 0.016);
  Random random(1);
  double area = 0;
  for (const ConvexPolygon& p : random_polygons(options, random).polygons) {
    const double own = area_properties(p.ring()).area;
    const double d = equivalent_diameter(own);
    CHECK(d >= 0.7 * 0.016 * (1 - 1e-12));
    CHECK(d <= 1.3 * 0.016 * (1 + 1e-12));
    area += own;
  }
  Random again(1);
  CHECK(random_polygons(options, again).area == near_relative(area, 1e-12));
  options.diameters.assign(40, 0.01);
  options.diameters[3] = 0.05;
  CHECK(mean_diameter(options) == near_relative(0.011, 1e-12));
}
