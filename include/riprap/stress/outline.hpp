// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The edges of a meshed particle, for finding places on its boundary without the mesh.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <riprap/core/vec2.hpp>
#include <riprap/stress/mesh/mesh.hpp>

namespace riprap {

/// The boundary point nearest to a place, and how long its edge remains the nearest one.
struct OutlinePoint {
  BoundaryPoint at{};
  /// While the place moves by less than this [m], its nearest boundary point stays on the edge.
  double hold = 0;
  /// The same for the edge and the second nearest one, if both meet in a corner next to the point.
  double corner_hold = 0;
  Vec2 corner{0, 0};
  Vec2 before{0, 0};  ///< unit vector from the corner along the edge that ends there
  Vec2 after{0, 0};   ///< and along the edge that begins there
  /// Of the point, along the boundary from the corner, counter-clockwise [m].
  double from_corner = 0;
};

/// What `Mesh::nearest_boundary_point` looks at, in one run of memory: finds the same points, to
/// the last bit, for where two edges are as near as each other it has to take the same one.
class Outline {
 public:
  Outline() = default;
  explicit Outline(const Mesh& mesh) : nodes_(mesh.boundary_nodes) {
    for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
      const std::uint32_t first = mesh.corners[k];
      const std::uint32_t end = k + 1 < mesh.corners.size() ? mesh.corners[k + 1] : nodes_;
      const Vec2 along = mesh.nodes[end % nodes_] - mesh.nodes[first];
      edges_.push_back(
          {mesh.nodes[first], along, along.dot(along), along.norm(), first, end - first});
    }
  }

  [[nodiscard]] std::uint32_t nodes() const { return nodes_; }

  [[nodiscard]] OutlinePoint nearest(const Vec2& x) const {
    constexpr double far = std::numeric_limits<double>::infinity();
    std::array<double, 3> least{far, far, far};  // squares of the distances to the nearest edges
    double place = 0;
    std::size_t best = 0;
    std::size_t next_best = 0;
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      const Edge& edge = edges_[k];
      const double along = std::clamp(edge.along.dot(x - edge.start) / edge.square, 0.0, 1.0);
      const Vec2 off = x - (edge.start + along * edge.along);
      const double square = off.dot(off);
      if (square < least[0]) {
        least = {square, least[0], least[1]};
        next_best = best;
        place = along;
        best = k;
      } else if (square < least[1]) {
        least = {least[0], square, least[1]};
        next_best = k;
      } else if (square < least[2]) {
        least[2] = square;
      }
    }
    const Edge& edge = edges_[best];
    // Nodes divide an edge evenly.
    const double parts = place * edge.parts;
    const auto part = std::min(static_cast<std::uint32_t>(parts), edge.parts - 1);
    const double distance = std::sqrt(least[0]);
    OutlinePoint point{
        .at = {edge.first + part, (edge.first + part + 1) % nodes_, 1 - (parts - part)},
        .hold = 0.5 * (std::sqrt(least[1]) - distance)};
    const double corner_hold = 0.5 * (std::sqrt(least[2]) - distance);
    if (next_best == (best + 1) % edges_.size() && part + 1 == edge.parts)
      meet(best, next_best, -(1 - place) * edge.length, corner_hold, point);
    else if (best == (next_best + 1) % edges_.size() && part == 0)
      meet(next_best, best, place * edge.length, corner_hold, point);
    return point;
  }

  [[nodiscard]] std::size_t bytes() const { return edges_.capacity() * sizeof(Edge); }

 private:
  struct Edge {
    Vec2 start;
    Vec2 along;
    double square;
    double length;
    std::uint32_t first;  // boundary node at its start
    std::uint32_t parts;
  };

  // Of the edges `before` and `after` a corner.
  void meet(std::size_t before, std::size_t after, double from_corner, double hold,
            OutlinePoint& point) const {
    const Edge& p = edges_[before];
    const Edge& q = edges_[after];
    const double spacing = std::min(p.length / p.parts, q.length / q.parts);
    point.corner = q.start;
    point.before = -p.along / p.length;
    point.after = q.along / q.length;
    point.from_corner = from_corner;
    // Nor beyond the nodes next to the corner.
    point.corner_hold = std::min(hold, spacing - std::abs(from_corner));
  }

  std::vector<Edge> edges_;
  std::uint32_t nodes_ = 0;
};

}  // namespace riprap
