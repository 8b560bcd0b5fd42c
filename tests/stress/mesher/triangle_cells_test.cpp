// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/mesher/triangle_cells.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <riprap/stress/mesher/fan_mesher.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>
#include <support/tessellation.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

void check_fills(const std::vector<ConvexPolygon>& cells, const ConvexPolygon& polygon,
                 double digits) {
  const CellComplex complex(cells);
  CHECK(complex.area() == near_relative(polygon_area(polygon.ring()), 1e-13 * digits));
  CHECK(complex.boundary_length() == near_relative(perimeter(polygon.ring()), 1e-13 * digits));
  CHECK(complex.edges_are_once());
  CHECK(complex.euler() == 1);
}

}  // namespace

TEST_CASE("triangles fill a polygon wherever it stands, and keep its vertices") {
  Random random(3);
  for (const Pose& pose : poses(1))
    for (int run = 0; run < 20; ++run) {
      const ConvexPolygon polygon = pose.of(random_polygon({}, 1, random));
      for (const double side : {0.1, 0.3}) {
        const auto cells = triangle_cells(polygon, side);
        check_fills(cells, polygon, pose.digits);
        // The area of an equilateral triangle; the mesher meets its count within some percent.
        const double wanted = polygon_area(polygon.ring()) / (std::sqrt(3.0) / 4 * side * side);
        CHECK(static_cast<double>(cells.size()) == near(wanted, 0.1 * wanted + 3));
        for (const Vec2& v : polygon)
          CHECK(std::any_of(cells.begin(), cells.end(), [&](const ConvexPolygon& cell) {
            return std::find(cell.begin(), cell.end(), v) != cell.end();
          }));
        // No slivers: width over length, 0.87 of an equilateral triangle.
        for (const ConvexPolygon& cell : cells)
          CHECK(least_width(cell.ring()) > 0.1 * diameter(cell.ring()));
      }
    }
}

TEST_CASE("any mesher will do: a fan has a triangle for each edge") {
  const ConvexPolygon hexagon = regular_polygon(6, 2).moved({}, {7, -3});
  const auto cells = triangle_cells(hexagon, FanMesher{});
  check_fills(cells, hexagon, 10);
  CHECK(cells.size() % 6 == 0);
}

TEST_CASE("a side that is not positive, or gives too many triangles, is refused") {
  CHECK(contains(message_of([] { (void)triangle_cells(unit_square(), 0.0); }), "side = 0"));
  CHECK(contains(message_of([] { (void)triangle_cells(unit_square(), 1e-3); }),
                 "must be at most 10,000"));
}
