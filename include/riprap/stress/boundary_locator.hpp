// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Nearest boundary point of a meshed particle, from a contiguous copy of its edges.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <riprap/core/linkage.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/stress/mesher/mesh.hpp>

namespace riprap {

/// The boundary point nearest to a position, and the radius within which its edge stays the
/// nearest.
struct LocatedPoint {
  BoundaryPoint at{};
  /// While the position moves by less than this [m], its nearest boundary point stays on the edge.
  double valid_radius = 0;
  /// The same for the nearest and the second nearest edge, if they share a corner next to the
  /// point.
  double corner_radius = 0;
  Vec2 corner{0, 0};
  Vec2 before{0, 0};  ///< unit vector from the corner along the edge that ends there
  Vec2 after{0, 0};   ///< and along the edge that begins there
  /// Arc length of the point from the corner, counter-clockwise positive [m].
  double from_corner = 0;
};

/// The edges of a mesh in contiguous memory. Where two edges are equally near, the first is taken.
class BoundaryLocator {
 public:
  BoundaryLocator() = default;
  explicit BoundaryLocator(const Mesh& mesh);

  [[nodiscard]] std::uint32_t nodes() const { return nodes_; }

  [[nodiscard]] LocatedPoint nearest(const Vec2& x) const;

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
  void describe_corner(std::size_t before, std::size_t after, double from_corner,
                       double valid_radius, LocatedPoint& point) const;

  std::vector<Edge> edges_;
  std::uint32_t nodes_ = 0;
};

/// The boundary point nearest to x (body frame); for many points keep a BoundaryLocator.
[[nodiscard]] inline BoundaryPoint nearest_boundary_point(const Mesh& mesh, const Vec2& x) {
  return BoundaryLocator(mesh).nearest(x).at;
}

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/stress/boundary_locator.ipp>
#endif
