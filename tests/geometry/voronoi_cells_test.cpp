// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/voronoi_cells.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>
#include <support/tessellation.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

/// Standard deviation of the cells' areas over their mean [-].
double unevenness(const std::vector<ConvexPolygon>& cells) {
  double sum = 0;
  double squares = 0;
  for (const ConvexPolygon& cell : cells) {
    const double area = polygon_area(cell.ring());
    sum += area;
    squares += area * area;
  }
  const double n = static_cast<double>(cells.size());
  return std::sqrt(std::max(0.0, squares / n - sum * sum / (n * n))) / (sum / n);
}

}  // namespace

TEST_CASE("Voronoi cells fill a polygon: areas, common edges, Euler's number") {
  Random random(4);
  for (const Pose& pose : poses(1))
    for (int run = 0; run < 12; ++run) {
      const ConvexPolygon polygon = pose.of(random_polygon({}, 1, random));
      for (const unsigned count : {1U, 2U, 7U, 60U}) {
        const auto relaxations = static_cast<unsigned>(run % 3 * 5);
        const auto cells = voronoi_cells(
            polygon,
            {.count = count, .relaxations = relaxations, .seed = static_cast<unsigned>(run)});
        CHECK(cells.size() == count);
        const CellComplex complex(cells);
        CHECK(complex.area() == near_relative(polygon_area(polygon.ring()), 1e-13 * pose.digits));
        CHECK(complex.boundary_length() ==
              near_relative(perimeter(polygon.ring()), 1e-13 * pose.digits));
        CHECK(complex.edges_are_once());
        CHECK(complex.euler() == 1);
      }
    }
}

TEST_CASE("cells are nearer to their own point than to any other") {
  const ConvexPolygon square = unit_square();
  const auto cells = voronoi_cells(square, {.count = 2, .relaxations = 200, .seed = 3});
  REQUIRE(cells.size() == 2);
  // Lloyd's iteration ends at two equal halves.
  for (const ConvexPolygon& cell : cells) CHECK(polygon_area(cell.ring()) == near(0.5, 1e-6));
  // Centroids of cells that no longer move are the points: every vertex of a cell is as near to
  // its own as to those of all cells that have it.
  const auto many = voronoi_cells(square, {.count = 20, .relaxations = 1000, .seed = 3});
  std::vector<Vec2> points;
  for (const ConvexPolygon& cell : many) points.push_back(area_properties(cell.ring()).centroid);
  for (std::size_t k = 0; k < many.size(); ++k)
    for (const Vec2& v : many[k])
      for (const Vec2& q : points) CHECK((v - points[k]).norm() <= (v - q).norm() + 1e-4);
}

TEST_CASE("relaxation makes cells even") {
  const ConvexPolygon square = unit_square();
  double before = 1;
  for (const unsigned relaxations : {0U, 4U, 50U}) {
    const auto cells = voronoi_cells(square, {.count = 200, .relaxations = relaxations});
    const double now = unevenness(cells);
    CHECK(now < before);  // 0.25, 0.13, 0.07
    before = now;
    double thinnest = 1;
    for (const ConvexPolygon& cell : cells)
      thinnest = std::min(thinnest, least_width(cell.ring()) / diameter(cell.ring()));
    CHECK(thinnest > 0.3);  // 0.38, 0.49, 0.65
  }
  // A random point each has cells of 0.53 (Poisson's; e.g. Okabe et al. 2000).
  CHECK(before < 0.15);
}

TEST_CASE("vertices that fall together become one") {
  // Four relaxed cells of a square meet near its middle.
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    const auto cells = voronoi_cells(unit_square(), {.count = 4, .relaxations = 300, .seed = seed});
    const CellComplex complex(cells);
    CHECK(complex.euler() == 1);
    CHECK(complex.area() == near(1, 1e-14));
    for (const ConvexPolygon& cell : cells)
      for (std::size_t k = 0; k < cell.size(); ++k)
        CHECK((cell[(k + 1) % cell.size()] - cell[k]).norm() > 1e-6);
  }
}

TEST_CASE("same seed, same bytes; another seed, other cells") {
  const ConvexPolygon pentagon = regular_polygon(5, 1);
  const auto first = voronoi_cells(pentagon, {.count = 30, .seed = 7});
  const auto again = voronoi_cells(pentagon, {.count = 30, .seed = 7});
  const auto other = voronoi_cells(pentagon, {.count = 30, .seed = 8});
  REQUIRE(first.size() == again.size());
  for (std::size_t k = 0; k < first.size(); ++k)
    CHECK(std::equal(first[k].begin(), first[k].end(), again[k].begin(), again[k].end()));
  CHECK_FALSE(std::equal(first[0].begin(), first[0].end(), other[0].begin(), other[0].end()));
}

TEST_CASE("the count of cells of a size, and options that break a rule") {
  CHECK(count_of_cells(1, 0.1) == 127);  // 4 / (pi 0.01)
  CHECK(count_of_cells(1, 5) == 1);
  CHECK(contains(message_of([] { (void)count_of_cells(1, 0); }), "mean_diameter = 0"));
  CHECK(contains(message_of([] { (void)voronoi_cells(unit_square(), {.count = 0}); }),
                 "VoronoiPoints.count = 0"));
  CHECK(contains(message_of([] { (void)voronoi_cells(unit_square(), {.relaxations = 1001}); }),
                 "VoronoiPoints.relaxations"));
}

TEST_CASE("a thousand cells, and a needle of a polygon") {
  const auto cells = voronoi_cells(regular_polygon(7, 1), {.count = 1000, .relaxations = 2});
  CHECK(CellComplex(cells).euler() == 1);
  const ConvexPolygon needle = rectangle(1, 1e-3);
  const CellComplex complex(voronoi_cells(needle, {.count = 40}));
  CHECK(complex.area() == near_relative(1e-3, 1e-12));
  CHECK(complex.euler() == 1);
}
