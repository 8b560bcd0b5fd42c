// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Near-uniform Delaunay triangles for any convex polygon: the default mesher.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/stress/mesh/concepts.hpp>
#include <riprap/stress/mesh/point_voronoi.hpp>

namespace riprap {

/// Divides the edges evenly, fills the inside with a triangular lattice along the longest edge, and
/// joins the points by Delaunay's rule. The spacing is the one that brings the number of triangles
/// nearest to the number asked for (of 100 asked for, half of random particles get 100 exactly and
/// nearly all 98 to 102). Built in the body's own frame from its edges, so that a turned particle
/// has the same mesh, turned. Throws InvalidInput for a polygon of aspect above 1e5, whose width
/// the integers of Boost.Polygon no longer resolve.
struct UniformMesher {
  unsigned triangles = 100;  ///< wanted for every particle, whatever its size

  [[nodiscard]] Mesh operator()(Ring ring) const {
    require(aspect(ring) <= 1e5, "UniformMesher: aspect of a polygon", aspect(ring),
            "must be 1e5 at most");
    Mesh mesh = best_points(ring);
    triangulate(ring, mesh);
    return mesh;
  }

  void validate() const {
    require(triangles >= 4 && triangles <= 10000, "UniformMesher.triangles", triangles,
            "must lie between 4 and 10000");
  }

 private:
  // Euler's relation: every triangulation of b hull points and i inner ones has 2 i + b - 2
  // triangles.
  [[nodiscard]] static std::size_t triangle_count(const Mesh& points) {
    return 2 * points.nodes.size() - points.boundary_nodes - 2;
  }

  [[nodiscard]] Mesh best_points(Ring ring) const {
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

  [[nodiscard]] static Mesh place_points(Ring ring, double spacing, double phase) {
    Mesh mesh;
    Vec2 longest{0, 0};
    std::vector<Edge> edges;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec2 along = ring[(k + 1) % ring.size()] - ring[k];
      if (along.dot(along) > longest.dot(longest)) longest = along;
      edges.push_back({ring[k], along, along.norm()});
      mesh.corners.push_back(static_cast<std::uint32_t>(mesh.nodes.size()));
      const auto parts =
          static_cast<unsigned>(std::max(1.0, std::round(edges[k].length / spacing)));
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

  struct Edge {
    Vec2 from;
    Vec2 along;
    double length;

    [[nodiscard]] double depth_of(const Vec2& x) const { return cross(along, x - from) / length; }
  };

  [[nodiscard]] static bool lies_inside(const std::vector<Edge>& edges, const Vec2& x,
                                        double depth) {
    return std::all_of(edges.begin(), edges.end(),
                       [&](const Edge& edge) { return edge.depth_of(x) > depth; });
  }

  // Points i of a row, from least to most.
  struct Range {
    double least, most;

    [[nodiscard]] bool has(int i) const { return least <= i && i <= most; }
    [[nodiscard]] int first(int reach) const {
      return static_cast<int>(std::ceil(std::min(least, reach + 1.0)));
    }
    // Those with slope * i > missing.
    void keep(double slope, double missing) {
      if (slope > 0)
        least = std::max(least, missing / slope);
      else if (slope < 0)
        most = std::min(most, missing / slope);
      else if (missing > 0)
        most = std::min(most, least - 1);
    }
  };
  // The points of a row that may lie inside, and those that surely do, whatever round-off says:
  // only the few between have to be tested.
  struct Row {
    Range maybe, surely;
  };
  [[nodiscard]] static Row row_inside(const std::vector<Edge>& edges, const Vec2& x, const Vec2& u,
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

  // Boost.Polygon works on integers. All points are drawn towards the centroid by a hair that grows
  // with their distance from it, which bends the edges outwards: the hull is strictly convex, and
  // no triangle lies flat on an edge or across a corner that is nearly straight.
  static void insert_points(Ring ring, const Mesh& mesh, PointVoronoiBuilder& builder) {
    const double size = diameter(ring);
    for (const Vec2& x : mesh.nodes) {
      const double scale = 1e9 / size * (1 - 3e-3 * x.dot(x) / (size * size));
      builder.insert_point(static_cast<std::int32_t>(std::lround(scale * x.x())),
                           static_cast<std::int32_t>(std::lround(scale * x.y())));
    }
  }

  // Where a slender polygon's edges bend by less than an integer, rounding may draw a boundary
  // point inwards, and a triangle covers the dent. It is known by its nodes: they follow each other
  // clockwise on the boundary, which no triangle inside a convex polygon does.
  [[nodiscard]] static bool lies_outside(const Mesh& mesh, std::uint32_t a, std::uint32_t b,
                                         std::uint32_t c) {
    if (std::max({a, b, c}) >= mesh.boundary_nodes) return false;
    return (a < b) + (b < c) + (c < a) == 1;
  }

  // The Delaunay triangles are the duals of the Voronoi vertices; where more than three cells meet,
  // their centres are joined as a fan.
  static void triangulate(Ring ring, Mesh& mesh) {
    PointVoronoiBuilder builder;
    insert_points(ring, mesh, builder);
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
};

static_assert(Mesher<UniformMesher>);

}  // namespace riprap
