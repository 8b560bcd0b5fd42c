// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/convex_parts.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include <riprap/core/random.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>
#include <support/tessellation.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

/// Corners that no convex part can have whole.
std::size_t concave_corners(Ring ring) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2& before = ring[(k + ring.size() - 1) % ring.size()];
    const Vec2& after = ring[(k + 1) % ring.size()];
    if (cross(ring[k] - before, after - ring[k]) <= 0) ++count;
  }
  return count;
}

/// Number of parts, after checks of all that the documentation promises.
std::size_t checked_parts(const std::vector<Vec2>& vertices) {
  const Outline outline(vertices);
  const Ring ring = outline.ring();
  const auto parts = convex_parts(outline);
  const CellComplex cells(parts);
  CHECK(cells.area() == near_relative(polygon_area(ring), 1e-14));
  CHECK(cells.edges_are_once());
  CHECK(cells.vertices() == ring.size());
  CHECK(cells.euler() == 1);
  // The edges of one part alone are those of the outline.
  CHECK(cells.boundary().size() == ring.size());
  for (const auto& [p, q] : cells.boundary()) {
    const Vec2 from{p.first, p.second};
    const auto at = std::find(ring.begin(), ring.end(), from) - ring.begin();
    REQUIRE(at < static_cast<std::ptrdiff_t>(ring.size()));
    CHECK(ring[(static_cast<std::size_t>(at) + 1) % ring.size()] == Vec2{q.first, q.second});
  }
  // Every cut ends at two corners at most, and no corner needs more than two.
  const std::size_t concave = concave_corners(ring);
  CHECK(parts.size() >= (concave + 1) / 2 + 1);
  CHECK(parts.size() <= 2 * concave + 1);
  return parts.size();
}

/// n tips on a circle of radius 1, and as many corners between them on one of `inner`.
std::vector<Vec2> star(std::size_t n, double inner) {
  std::vector<Vec2> out;
  for (std::size_t k = 0; k < 2 * n; ++k) {
    const double angle = pi * static_cast<double>(k) / static_cast<double>(n);
    out.push_back((k % 2 == 0 ? 1 : inner) * (Rotation::from_angle(angle) * Vec2{1, 0}));
  }
  return out;
}

/// n teeth, one wide and two high, on a bar.
std::vector<Vec2> comb(int n) {
  std::vector<Vec2> out{{0, -1}, {2.0 * n - 1, -1}};
  for (int k = n - 1; k >= 0; --k) {
    out.push_back({2.0 * k + 1, 0});
    out.push_back({2.0 * k + 1, 2});
    out.push_back({2.0 * k, 2});
    out.push_back({2.0 * k, 0});
  }
  // The outermost corners of the bar lie within its sides.
  return out;
}

}  // namespace

TEST_CASE("outlines with a known least number of parts") {
  // Convex: one part, of the same vertices.
  CHECK(checked_parts({{0, 0}, {1, 0}, {1, 1}, {0, 1}}) == 1);
  const ConvexPolygon twenty = regular_polygon(20, 1);
  CHECK(checked_parts({twenty.begin(), twenty.end()}) == 1);
  // One concave corner: two parts.
  CHECK(checked_parts({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}) == 2);
  CHECK(checked_parts({{0, 0}, {2, 1}, {0, 2}, {0.5, 1}}) == 2);
  // A plus has four of them: three parts at least, with corners within edges; along whole edges
  // the square in the middle and the arms, five.
  CHECK(checked_parts({{1, 0},
                       {2, 0},
                       {2, 1},
                       {3, 1},
                       {3, 2},
                       {2, 2},
                       {2, 3},
                       {1, 3},
                       {1, 2},
                       {0, 2},
                       {0, 1},
                       {1, 1}}) == 5);
  // A star: its pentagon and five tips at most; four at least.
  CHECK(checked_parts(star(5, 0.4)) <= 6);
  // A square spiral.
  CHECK(checked_parts({{0, 0},
                       {5, 0},
                       {5, 5},
                       {1, 5},
                       {1, 2},
                       {3, 2},
                       {3, 3},
                       {2, 3},
                       {2, 4},
                       {4, 4},
                       {4, 1},
                       {0, 1}}) <= 8);
}

TEST_CASE("a comb has a part for each tooth and the bar") {
  for (const int teeth : {2, 5, 12}) {
    const std::size_t parts = checked_parts(comb(teeth));
    CHECK(parts >= static_cast<std::size_t>(teeth));
    CHECK(parts <= static_cast<std::size_t>(4 * teeth));
  }
}

TEST_CASE("random outlines are filled by parts, turned and far away too") {
  Random random(5);
  std::size_t most = 0;
  for (int run = 0; run < 200; ++run) {
    const unsigned n = random.uniform_integer(3, 60);
    const double roughness = random.uniform(0.1, 0.9);
    std::vector<Vec2> ring;
    for (unsigned k = 0; k < n; ++k) {
      const double angle = 2 * pi * (k + random.uniform(0, 0.9)) / n;
      const double radius = random.uniform(1 - roughness, 1);
      ring.push_back(radius * (Rotation::from_angle(angle) * Vec2{1, 0}) + Vec2{run * 5.0, 0});
    }
    most = std::max(most, checked_parts(ring));
  }
  CHECK(most > 10);
}

TEST_CASE("a triangulation by the corners has n - 2 triangles and Delaunay's diagonals") {
  // Of a convex quadrangle the diagonal is the one whose triangles are less sharp.
  const Outline kite({{0, 0}, {4, -1}, {8, 0}, {4, 1}});
  for (const TriangleIndices& t : triangulate(kite))
    CHECK(std::count(t.begin(), t.end(), 1U) + std::count(t.begin(), t.end(), 3U) == 2);
  for (const std::size_t n : {3U, 7U, 40U}) {
    const Outline outline(star(n, 0.4));
    const auto triangles = triangulate(outline);
    CHECK(triangles.size() == 2 * n - 2);
    double sum = 0;
    for (const TriangleIndices& t : triangles)
      sum += 0.5 * cross(outline.ring()[t[1]] - outline.ring()[t[0]],
                         outline.ring()[t[2]] - outline.ring()[t[0]]);
    CHECK(sum == near_relative(polygon_area(outline.ring()), 1e-14));
  }
}

TEST_CASE("a convex outline of more vertices than a polygon may have is cut into a few") {
  std::vector<Vec2> ring;
  for (int k = 0; k < 100; ++k) ring.push_back(Rotation::from_angle(2 * pi * k / 100) * Vec2{1, 0});
  const auto parts = convex_parts(Outline(ring));
  CHECK(parts.size() == 3);  // 33 vertices, 33 and 38
  CHECK(CellComplex(parts).euler() == 1);
  CHECK(CellComplex(parts).area() == near_relative(polygon_area(ring), 1e-14));
}
