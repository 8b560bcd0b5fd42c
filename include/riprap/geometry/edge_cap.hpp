#pragma once
/// @file
/// What one convex ring has inside another where it enters through a single edge.

#include <cmath>
#include <cstddef>
#include <optional>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/edge_side.hpp>

namespace riprap {

/// The part of a convex ring that lies beyond one edge of another.
struct EdgeCap {
  Vec2 entry{0, 0};   ///< where the boundary of the entering ring crosses the edge going in ...
  Vec2 exit{0, 0};    ///< ... and going out
  double chord = 0;   ///< distance of the two [m]
  double depth = 0;   ///< of the deepest vertex below the edge [m]
  double area = 0;    ///< [m^2]
  Vec2 normal{1, 0};  ///< of the edge, outwards
};

namespace internal {

/// Lies v inside all edges of `ring` but edge `i`, by `margin` [m] times the edge's length in the
/// sum of its components?
[[nodiscard]] inline bool inside_other_edges(Ring ring, std::size_t i, const Vec2& v,
                                             double margin) {
  const std::size_t n = ring.size();
  bool inside = true;
  Vec2 p = ring[n - 1];
  for (std::size_t j = n - 1, next = 0; next < n; j = next++) {
    const Vec2 q = ring[next];
    const Vec2 edge = q - p;
    const double distance = cross(edge, v - p);
    inside &= j == i || distance > margin * (std::abs(edge.x()) + std::abs(edge.y()));
    p = q;
  }
  return inside;
}

}  // namespace internal

/// The cap of `other` beyond edge `i` of `ring`, if it is all that the two have in common: the
/// boundaries cross twice, both times on that edge. A corner in an edge is the commonest contact of
/// polygons; knowing the edge, this costs a fifth of clipping. Nothing where that is not so by a
/// clear `margin` [m]: with one far above round-off, exact arithmetic would agree.
/// @param side of `other` to that edge
[[nodiscard]] inline std::optional<EdgeCap> edge_cap(Ring ring, std::size_t i, Ring other,
                                                     const EdgeSide& side, double margin) {
  const std::size_t n = other.size();
  if (side.inside == 0 || side.inside == n) return std::nullopt;
  std::size_t first = 0;  // of the run of vertices inside
  if (side.distances[0] >= 0) {
    first = n - 1;
    while (side.distances[first] >= 0) --first;
    first = first + 1 == n ? 0 : first + 1;
  } else {
    while (side.distances[first] < 0) ++first;
  }
  const std::size_t before = first == 0 ? n - 1 : first - 1;
  std::size_t last = first + side.inside - 1;
  if (last >= n) last -= n;
  const std::size_t after = last + 1 == n ? 0 : last + 1;

  const Vec2& p = ring[i];
  const Vec2 edge = ring[i + 1 == ring.size() ? 0 : i + 1] - p;
  const double length = std::sqrt(edge.dot(edge));
  const double clear = margin * length;
  if (!(side.deepest > clear)) return std::nullopt;

  const auto crossing = [&](std::size_t in, std::size_t out) -> Vec2 {
    const double d = side.distances[in];
    return other[in] + (d / (d - side.distances[out])) * (other[out] - other[in]);
  };
  EdgeCap cap;
  cap.entry = crossing(first, before);
  cap.exit = crossing(last, after);
  const double entered = edge.dot(cap.entry - p);
  const double left = edge.dot(cap.exit - p);
  if (!(left > clear && entered - left > clear && length * length - entered > clear))
    return std::nullopt;

  double twice_area = 0;
  Vec2 previous = cap.entry - cap.exit;
  for (std::size_t k = first, run = 0; run < side.inside; ++run) {
    if (!(side.distances[k] > clear) || !internal::inside_other_edges(ring, i, other[k], margin))
      return std::nullopt;
    const Vec2 arm = other[k] - cap.exit;
    twice_area += cross(previous, arm);
    previous = arm;
    k = k + 1 == n ? 0 : k + 1;
  }
  if (!(-side.distances[before] > clear && -side.distances[after] > clear)) return std::nullopt;

  const double scale = 1 / length;
  cap.chord = (entered - left) * scale;
  cap.depth = side.deepest * scale;
  cap.area = 0.5 * twice_area;
  cap.normal = -scale * perpendicular(edge);
  return cap;
}

}  // namespace riprap
