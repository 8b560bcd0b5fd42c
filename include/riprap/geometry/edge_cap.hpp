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

/// Does v lie to the left of the line from p to q by `margin` [m], or a little more?
[[nodiscard]] inline bool left_of(const Vec2& p, const Vec2& q, const Vec2& v, double margin) {
  const double x = q.x() - p.x();
  const double y = q.y() - p.y();
  return x * (v.y() - p.y()) - y * (v.x() - p.x()) > margin * (std::abs(x) + std::abs(y));
}

/// Does v, inside edge `i` of a convex ring, lie inside all other edges as well, by a clear margin
/// [m]?
[[nodiscard]] inline bool inside_other_edges(Ring ring, std::size_t i, const Vec2& v,
                                             double margin) {
  const std::size_t n = ring.size();
  const Vec2& p = ring[i];
  const Vec2& q = ring[i + 1 == n ? 0 : i + 1];
  // The triangle over the edge to a vertex across holds most of what lies near the edge.
  const std::size_t across = i + n / 2 + 1;
  const Vec2& c = ring[across < n ? across : across - n];
  if (left_of(q, c, v, 1.5 * margin) && left_of(c, p, v, 1.5 * margin)) return true;
  for (std::size_t j = 0; j < n; ++j)
    if (j != i && !left_of(ring[j], ring[j + 1 == n ? 0 : j + 1], v, margin)) return false;
  return true;
}

}  // namespace internal

/// The cap of `other` beyond edge `i` of `ring`, if it is all that the two have in common: the
/// boundaries cross twice, both times on that edge. Nothing where that is not so by a clear
/// `margin` [m]: with one far above round-off, exact arithmetic would agree.
/// @param side of `other` to that edge
[[nodiscard]] inline std::optional<EdgeCap> edge_cap(Ring ring, std::size_t i, Ring other,
                                                     const EdgeSide& side, double margin) {
  const std::size_t n = other.size();
  if (side.inside == 0 || side.inside == n) return std::nullopt;
  const InsideRun run = inside_run(side, n);
  if (!run.unbroken) return std::nullopt;

  const Vec2& p = ring[i];
  const Vec2 edge = ring[i + 1 == ring.size() ? 0 : i + 1] - p;
  const double length = std::sqrt(edge.dot(edge));
  const double clear = margin * length;
  const auto crossing = [&](std::size_t in, std::size_t out) -> Vec2 {
    const double d = side.distances[in];
    return other[in] + (d / (d - side.distances[out])) * (other[out] - other[in]);
  };
  EdgeCap cap;
  cap.entry = crossing(run.first, run.before);
  cap.exit = crossing(run.last, run.after);
  const double entered = edge.dot(cap.entry - p);
  const double left = edge.dot(cap.exit - p);
  // One after the other these would be six branches.
  const bool on_edge = (left > clear) & (entered - left > clear) &
                       (length * length - entered > clear) & (-side.distances[run.before] > clear) &
                       (-side.distances[run.after] > clear);
  if (!on_edge) return std::nullopt;

  double twice_area = 0;
  Vec2 previous = cap.entry - cap.exit;
  for (std::size_t k = run.first, left_over = side.inside; left_over > 0; --left_over) {
    if (!(side.distances[k] > clear) || !internal::inside_other_edges(ring, i, other[k], margin))
      return std::nullopt;
    const Vec2 arm = other[k] - cap.exit;
    twice_area += cross(previous, arm);
    previous = arm;
    k = k + 1 == n ? 0 : k + 1;
  }

  const double scale = 1 / length;
  cap.chord = (entered - left) * scale;
  cap.depth = side.deepest * scale;
  cap.area = 0.5 * twice_area;
  cap.normal = -scale * perpendicular(edge);
  return cap;
}

}  // namespace riprap
