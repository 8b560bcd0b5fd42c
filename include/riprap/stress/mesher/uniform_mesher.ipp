// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/stress/mesher/point_voronoi.hpp>
#include <riprap/stress/mesher/uniform_mesher.hpp>

namespace riprap {

namespace internal {

// Boost.Polygon works on integers. All points are displaced slightly towards the centroid, by an
// amount that grows with their distance from it, which bends the edges outwards: the hull is
// strictly convex, and no triangle lies flat on an edge or across a corner that is nearly straight.
RIPRAP_INLINE void insert_points(Ring ring, const Mesh& mesh, PointVoronoiBuilder& builder) {
  const double size = diameter(ring);
  for (const Vec2& x : mesh.nodes) {
    const double scale = 1e9 / size * (1 - 3e-3 * x.dot(x) / (size * size));
    builder.insert_point(static_cast<std::int32_t>(std::lround(scale * x.x())),
                         static_cast<std::int32_t>(std::lround(scale * x.y())));
  }
}

}  // namespace internal

template <class Once>
Mesh UniformMesher::operator()(Ring ring) const {
  require(aspect(ring) <= 1e5, "UniformMesher: aspect of a polygon", aspect(ring),
          "must be 1e5 at most");
  Mesh mesh = best_points(ring);
  triangulate<Once>(ring, mesh);
  return mesh;
}

RIPRAP_INLINE void UniformMesher::validate() const {
  require(triangles >= 4 && triangles <= 10000, "UniformMesher.triangles", triangles,
          "must lie between 4 and 10000");
}

RIPRAP_INLINE Mesh UniformMesher::best_points(Ring ring) const {
  const double area = area_properties(ring).area;
  const double equilateral = std::sqrt(4 * area / (std::sqrt(3.0) * triangles));
  Mesh best;
  double best_miss = std::numeric_limits<double>::infinity();
  // From the ideal spacing outwards to both sides, so that ties keep the most regular layout; at
  // each spacing the lattice may have a point, or the middle of a triangle, at the centroid.
  for (int k = 0; k <= 60; ++k)
    for (const double phase : {0.0, 1.0 / 3}) {
      const double spacing = equilateral * (1 + 0.01 * (k % 2 ? -(k + 1) / 2 : k / 2));
      Mesh points = place_points(ring, spacing, phase);
      const double miss =
          std::abs(static_cast<double>(triangle_count(points)) - static_cast<double>(triangles));
      if (miss >= best_miss) continue;
      best_miss = miss;
      best = std::move(points);
      if (miss == 0) return best;
    }
  return best;
}

RIPRAP_INLINE Mesh UniformMesher::place_points(Ring ring, double spacing, double phase) {
  Mesh mesh;
  Vec2 longest{0, 0};
  std::vector<Edge> edges;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2 along = ring[(k + 1) % ring.size()] - ring[k];
    if (along.dot(along) > longest.dot(longest)) longest = along;
    edges.push_back({ring[k], along, along.norm()});
    mesh.corners.push_back(static_cast<std::uint32_t>(mesh.nodes.size()));
    const auto parts = static_cast<unsigned>(std::max(1.0, std::round(edges[k].length / spacing)));
    for (unsigned i = 0; i < parts; ++i)
      mesh.nodes.push_back(ring[k] + (static_cast<double>(i) / parts) * along);
  }
  mesh.boundary_nodes = static_cast<std::uint32_t>(mesh.nodes.size());

  const Vec2 u = spacing * longest.normalized();
  const Vec2 v = 0.5 * u + std::sqrt(0.75) * perpendicular(u);
  double height = 0;
  for (const Vec2& vertex : ring) height = std::max(height, std::abs(cross(u, vertex)) / spacing);
  const int reach = static_cast<int>(1.2 * diameter(ring) / spacing) + 1;
  const int rows = static_cast<int>(1.2 * height / spacing) + 1;
  const double depth = 0.6 * spacing;
  for (int j = -rows; j <= rows; ++j) {
    const auto point = [&](int i) -> Vec2 { return (i + phase) * u + (j + phase) * v; };
    const Row row = row_inside(edges, point(0), u, depth, reach);
    for (int i = row.maybe.first(reach); i <= row.maybe.most; ++i) {
      const Vec2 x = point(i);
      if (row.surely.has(i) || lies_inside(edges, x, depth)) mesh.nodes.push_back(x);
    }
  }
  return mesh;
}

RIPRAP_INLINE bool UniformMesher::lies_inside(const std::vector<Edge>& edges, const Vec2& x,
                                              double depth) {
  return std::all_of(edges.begin(), edges.end(),
                     [&](const Edge& edge) { return edge.depth_of(x) > depth; });
}

RIPRAP_INLINE UniformMesher::Row UniformMesher::row_inside(const std::vector<Edge>& edges,
                                                           const Vec2& x, const Vec2& u,
                                                           double depth, int reach) {
  const double room = 1e-9 * depth;
  const Range all{-1.0 * reach, 1.0 * reach};
  Row row{all, all};
  for (const Edge& edge : edges) {
    // Depth grows by `slope` from point to point; not along an edge.
    const double exact = cross(edge.along, u) / edge.length;
    const double slope = std::abs(exact) * reach < 0.1 * room ? 0 : exact;
    const double missing = depth - edge.depth_of(x);
    row.maybe.keep(slope, missing - room);
    row.surely.keep(slope, missing + room);
  }
  return row;
}

template <class Once>
void UniformMesher::triangulate(Ring ring, Mesh& mesh) {
  PointVoronoiBuilder builder;
  internal::insert_points(ring, mesh, builder);
  PointVoronoi voronoi;
  builder.construct(&voronoi);
  std::vector<std::uint32_t> around;
  for (const auto& vertex : voronoi.vertices()) {
    around.clear();
    const auto* first = vertex.incident_edge();
    const auto* edge = first;
    do {
      around.push_back(static_cast<std::uint32_t>(edge->cell()->source_index()));
      edge = edge->rot_next();
    } while (edge != first);
    // rot_next turns counter-clockwise, and so do the triangles.
    for (std::size_t k = 1; k + 1 < around.size(); ++k)
      if (!lies_outside(mesh, around[0], around[k], around[k + 1]))
        mesh.triangles.push_back({around[0], around[k], around[k + 1]});
  }
  if (mesh.size() != triangle_count(mesh))
    throw SimulationError("mesh has " + std::to_string(mesh.size()) + " triangles where " +
                          std::to_string(triangle_count(mesh)) + " were expected");
}

}  // namespace riprap

#ifdef RIPRAP_COMPILED
template riprap::Mesh riprap::UniformMesher::operator()<void>(Ring) const;
#endif
