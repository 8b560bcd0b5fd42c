// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Near-uniform Delaunay triangles for any convex polygon: the default mesher.

#include <cmath>
#include <cstdint>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/stress/mesher/concepts.hpp>

namespace riprap {

/// Divides the edges evenly, fills the inside with a triangular lattice along the longest edge, and
/// joins the points by Delaunay's rule. The spacing is the one that brings the number of triangles
/// nearest to the number asked for (of 100 asked for, half of random particles get 100 exactly and
/// nearly all 98 to 102). Built in the body's own frame from its edges, so that a turned particle
/// has the same mesh, turned. Throws InvalidInput for a polygon of aspect above 1e5, whose width
/// the integers of Boost.Polygon no longer resolve.
struct UniformMesher {
  unsigned triangles = 100;  ///< wanted for every particle, whatever its size

  // A template, so that a program that makes no mesh does not compile Boost.Polygon.
  template <class Once = void>
  [[nodiscard]] Mesh operator()(Ring ring) const;

  static void for_each_field(auto& self, auto&& visit) { visit("triangles", self.triangles); }

  void validate() const;

 private:
  // Euler's relation: every triangulation of b hull points and i inner ones has 2 i + b - 2
  // triangles.
  [[nodiscard]] static std::size_t triangle_count(const Mesh& points) {
    return 2 * points.nodes.size() - points.boundary_nodes - 2;
  }

  [[nodiscard]] Mesh best_points(Ring ring) const;

  [[nodiscard]] static Mesh place_points(Ring ring, double spacing, double phase);

  struct Edge {
    Vec2 from;
    Vec2 along;
    double length;

    [[nodiscard]] double depth_of(const Vec2& x) const { return cross(along, x - from) / length; }
  };

  [[nodiscard]] static bool lies_inside(const std::vector<Edge>& edges, const Vec2& x,
                                        double depth);

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
                                      double depth, int reach);

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
  template <class Once>
  static void triangulate(Ring ring, Mesh& mesh);
};

static_assert(Mesher<UniformMesher>);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/stress/mesher/uniform_mesher.ipp>
#else
extern template riprap::Mesh riprap::UniformMesher::operator()<void>(Ring) const;
#endif
