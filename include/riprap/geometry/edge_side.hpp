#pragma once
/// @file
/// How the vertices of one convex ring lie to one edge of another.

#include <array>
#include <cmath>
#include <cstddef>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/convex_polygon.hpp>

namespace riprap {

/// Distances of a ring's vertices from the line of an edge, inwards.
struct EdgeSide {
  /// Times the length of the edge [m^2]; as many as there are vertices.
  std::array<double, max_polygon_vertices> distances;
  double deepest = 0;      ///< greatest of them
  std::size_t inside = 0;  ///< how many are not negative

  /// Of the deepest vertex below edge `i` of `ring` [m]; negative: so far apart are the two.
  [[nodiscard]] double depth(Ring ring, std::size_t i) const {
    const Vec2 edge = ring[i + 1 == ring.size() ? 0 : i + 1] - ring[i];
    return deepest / std::sqrt(edge.dot(edge));
  }
};

/// Where the vertices of `other` lie to edge `i` of `ring`.
[[nodiscard]] inline EdgeSide edge_side(Ring ring, std::size_t i, Ring other) {
  EdgeSide side;
  const Vec2 p = ring[i];
  const Vec2 edge = ring[i + 1 == ring.size() ? 0 : i + 1] - p;
  for (std::size_t k = 0; k < other.size(); ++k) side.distances[k] = cross(edge, other[k] - p);
  side.deepest = side.distances[0];
  for (std::size_t k = 0; k < other.size(); ++k) {
    side.deepest = side.distances[k] > side.deepest ? side.distances[k] : side.deepest;
    side.inside += side.distances[k] >= 0;
  }
  return side;
}

}  // namespace riprap
