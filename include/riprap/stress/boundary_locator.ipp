// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <riprap/stress/boundary_locator.hpp>

namespace riprap {

RIPRAP_INLINE BoundaryLocator::BoundaryLocator(const Mesh& mesh) : nodes_(mesh.boundary_nodes) {
  for (std::size_t k = 0; k < mesh.corners.size(); ++k) {
    const std::uint32_t first = mesh.corners[k];
    const std::uint32_t end = k + 1 < mesh.corners.size() ? mesh.corners[k + 1] : nodes_;
    const Vec2 along = mesh.nodes[end % nodes_] - mesh.nodes[first];
    edges_.push_back(
        {mesh.nodes[first], along, along.dot(along), along.norm(), first, end - first});
  }
}

RIPRAP_INLINE LocatedPoint BoundaryLocator::nearest(const Vec2& x) const {
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
  LocatedPoint point{
      .at = {edge.first + part, (edge.first + part + 1) % nodes_, 1 - (parts - part)},
      .valid_radius = 0.5 * (std::sqrt(least[1]) - distance)};
  const double corner_radius = 0.5 * (std::sqrt(least[2]) - distance);
  if (next_best == (best + 1) % edges_.size() && part + 1 == edge.parts)
    describe_corner(best, next_best, -(1 - place) * edge.length, corner_radius, point);
  else if (best == (next_best + 1) % edges_.size() && part == 0)
    describe_corner(next_best, best, place * edge.length, corner_radius, point);
  return point;
}

RIPRAP_INLINE void BoundaryLocator::describe_corner(std::size_t before, std::size_t after,
                                                    double from_corner, double valid_radius,
                                                    LocatedPoint& point) const {
  const Edge& p = edges_[before];
  const Edge& q = edges_[after];
  const double spacing = std::min(p.length / p.parts, q.length / q.parts);
  point.corner = q.start;
  point.before = -p.along / p.length;
  point.after = q.along / q.length;
  point.from_corner = from_corner;
  // Nor beyond the nodes next to the corner.
  point.corner_radius = std::min(valid_radius, spacing - std::abs(from_corner));
}

}  // namespace riprap
