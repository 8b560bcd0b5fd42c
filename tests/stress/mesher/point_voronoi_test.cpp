// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/mesher/point_voronoi.hpp>

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <doctest/doctest.h>
#include <vector>

#include <riprap/core/random.hpp>

using namespace riprap;

namespace {

using Point = boost::polygon::point_data<std::int32_t>;

// A vertex with the points around it.
struct Vertex {
  double x, y;
  std::vector<std::size_t> points;
  bool operator==(const Vertex&) const = default;
};

std::vector<Vertex> vertices(const PointVoronoi& diagram) {
  std::vector<Vertex> found;
  for (const auto& vertex : diagram.vertices()) {
    Vertex& v = found.emplace_back(Vertex{vertex.x(), vertex.y(), {}});
    const auto* edge = vertex.incident_edge();
    do {
      v.points.push_back(edge->cell()->source_index());
      edge = edge->rot_next();
    } while (edge != vertex.incident_edge());
  }
  return found;
}

std::vector<Vertex> ours(const std::vector<Point>& points) {
  PointVoronoiBuilder builder;
  for (const Point& p : points) builder.insert_point(p.x(), p.y());
  PointVoronoi diagram;
  builder.construct(&diagram);
  return vertices(diagram);
}

// With the predicates that Boost.Polygon has for points and segments.
std::vector<Vertex> of_boost(const std::vector<Point>& points) {
  PointVoronoi diagram;
  boost::polygon::construct_voronoi(points.begin(), points.end(), &diagram);
  return vertices(diagram);
}

}  // namespace

TEST_CASE("four points on a circle share one vertex, its centre") {
  const auto found = ours({{-3, -4}, {3, -4}, {3, 4}, {-3, 4}});
  REQUIRE(found.size() == 1);
  // Both are sums of small integers, exact.
  CHECK(found[0].x == 0);
  CHECK(found[0].y == 0);
  auto points = found[0].points;
  std::sort(points.begin(), points.end());
  CHECK(points == std::vector<std::size_t>{0, 1, 2, 3});
}

TEST_CASE("points on a line have no vertex") {
  CHECK(ours({{0, 0}, {1, 0}, {5, 0}}).empty());
  CHECK(ours({{0, 0}, {0, 1}, {0, 5}}).empty());
}

// The same code decides, so that not a bit may differ.
TEST_CASE("the diagram of scattered points is that of Boost.Polygon, bit for bit") {
  Random random(7);
  for (int sample = 0; sample < 50; ++sample) {
    std::vector<Point> points;
    for (int i = 0; i < 100; ++i)
      points.emplace_back(static_cast<int>(random.uniform(-1e9, 1e9)),
                          static_cast<int>(random.uniform(-1e9, 1e9)));
    const auto found = ours(points);
    CHECK(found.size() > 150);  // Euler: 2 n - 2 less the hull
    CHECK(found == of_boost(points));
  }
}

TEST_CASE("so is that of points that share circles, and of some that nearly do") {
  Random random(8);
  for (const int scale : {1, 1000, 50000000}) {
    std::vector<Point> lattice;
    for (int i = -9; i <= 9; ++i)
      for (int j = -9; j <= 9; ++j)
        lattice.emplace_back(scale * i, scale * j + static_cast<int>(random.uniform(-2, 2)));
    CHECK(ours(lattice) == of_boost(lattice));
  }
}
