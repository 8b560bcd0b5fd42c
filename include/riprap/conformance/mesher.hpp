// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the mesher.

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <riprap/conformance/units.hpp>
#include <riprap/conformance/violations.hpp>
#include <riprap/core/random.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <riprap/stress/mesher/concepts.hpp>

namespace riprap {
namespace internal {

/// The triangles of a mesh taken together.
[[nodiscard]] inline AreaProperties covered(const Mesh& mesh) {
  AreaProperties sum;
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    const auto corners = mesh.triangle(e);
    const AreaProperties one = area_properties(corners);
    sum.area += one.area;
    sum.centroid += one.area * one.centroid;
    sum.polar_moment += one.polar_moment + one.area * one.centroid.squaredNorm();
  }
  sum.centroid /= sum.area;
  return sum;
}

/// Corners at the vertices of the ring, and nodes that divide every edge evenly.
inline void check_boundary(const Mesh& mesh, Ring ring, double round_off, AxiomCheck& check) {
  const bool counted = mesh.corners.size() == ring.size() && mesh.corners[0] == 0 &&
                       mesh.boundary_nodes <= mesh.nodes.size();
  check.holds("every vertex of the polygon is a corner, vertex 0 node 0", counted);
  if (!counted) return;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2& p = ring[k];
    const Vec2 edge = ring[(k + 1) % ring.size()] - p;
    const std::uint32_t first = mesh.corners[k];
    const std::uint32_t end = k + 1 < ring.size() ? mesh.corners[k + 1] : mesh.boundary_nodes;
    check.holds("corners come in the order of the vertices", first < end);
    for (std::uint32_t i = first; i < end && i < mesh.nodes.size(); ++i)
      check.equal("boundary nodes divide each edge evenly: distance from their place",
                  (mesh.nodes[i] - p - edge * (double(i - first) / double(end - first))).norm(), 0,
                  round_off);
  }
}

/// Every side of a triangle is one of its neighbour, run the other way, or one of the boundary.
inline void check_joined(const Mesh& mesh, AxiomCheck& check) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++sides[{t[k], t[(k + 1) % 3]}];
  for (const auto& [side, count] : sides) {
    const auto [from, to] = side;
    const bool outer = from < mesh.boundary_nodes && to == (from + 1) % mesh.boundary_nodes;
    check.holds("triangles join edge to edge", count == 1 && (outer || sides.contains({to, from})));
  }
}

/// Random polygons of about `size` [m] with 3 to 7 vertices, centroids at the origin.
[[nodiscard]] inline std::vector<ConvexPolygon> centred_polygons(double size) {
  Random random(1);
  std::vector<ConvexPolygon> polygons;
  for (int i = 0; i < 20; ++i)
    polygons.push_back(random_polygon({.most_vertices = 7}, size, random));
  return polygons;
}

}  // namespace internal

/// Which axioms a mesher breaks for random polygons of about `size` [m].
template <Mesher M>
[[nodiscard]] Violations mesher_violations(const M& mesher, double size = 0.016) {
  AxiomCheck check;
  for (const ConvexPolygon& polygon : internal::centred_polygons(size)) {
    const Mesh mesh = mesher(polygon.ring());
    const AreaProperties whole = area_properties(polygon.ring());
    const AreaProperties sum = internal::covered(mesh);
    const double round_off = 1e-12 * size;
    check.equal("the triangles have the area of the polygon", sum.area, whole.area,
                round_off * size);
    check.equal("the triangles have the centroid of the polygon",
                (sum.centroid - whole.centroid).norm(), 0, round_off);
    check.equal("the triangles have the polar moment of the polygon", sum.polar_moment,
                whole.polar_moment, round_off * size * size * size);
    for (std::size_t e = 0; e < mesh.size(); ++e)
      check.at_least("triangles are counter-clockwise: area", mesh.area(e), 1e-9 * whole.area);
    internal::check_boundary(mesh, polygon.ring(), round_off, check);
    internal::check_joined(mesh, check);
  }
  return std::move(check).violations();
}

/// Which nodes move, and which triangles change, when polygon and mesher are given in other units
/// of length.
/// @param other `mesher` with its parameters in `units`
template <Mesher M>
[[nodiscard]] Violations mesher_unit_violations(const M& mesher, const M& other,
                                                const Units& units = {}, double size = 0.016) {
  AxiomCheck check;
  for (const ConvexPolygon& polygon : internal::centred_polygons(size)) {
    std::vector<Vec2> ring;
    for (const Vec2& v : polygon) ring.push_back(units.length * v);
    const Mesh mesh = mesher(polygon.ring());
    const Mesh same = other(ring);
    check.holds("triangles are the same in other units", same.triangles == mesh.triangles);
    for (std::size_t i = 0; i < mesh.nodes.size() && i < same.nodes.size(); ++i)
      check.equal("nodes are the same in other units: distance",
                  (same.nodes[i] / units.length - mesh.nodes[i]).norm(), 0, 1e-12 * size);
  }
  return std::move(check).violations();
}

}  // namespace riprap
