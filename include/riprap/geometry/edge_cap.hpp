#pragma once
/// @file
/// What one convex ring has inside another where it enters through a single edge.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/line_side.hpp>

namespace riprap {

/// The part of a convex ring that lies beyond one edge of another. Its base is the chord on the
/// edge from where the boundary of the entering ring comes out to where it goes in.
struct EdgeCap {
  Vec2 normal{1, 0};  ///< of the edge, outwards
  Vec2 middle{0, 0};  ///< of the chord
  double depth = 0;   ///< of the deepest vertex below the edge [m]
  double area = 0;    ///< [m^2]
  double chord = 0;   ///< its length [m]
};

/// Where a cap is: one or two neighbouring vertices of the entering ring lie beyond an edge of the
/// other. All vertices that have a part in it, by their numbers, so that a pair that stays as it is
/// need not look for them again (25 instructions of a contact).
struct EntryPlace {
  std::uint8_t ring_size = 0;   ///< of the ring with the edge; 0: nowhere
  std::uint8_t other_size = 0;  ///< of the ring that enters
  std::uint8_t edge = 0;        ///< where it begins
  std::uint8_t edge_end = 0;
  std::uint8_t across = 0;  ///< vertex of the ring opposite to the edge
  std::uint8_t first = 0;   ///< of the entering ring, beyond the edge
  std::uint8_t last = 0;    ///< the same as `first`, or the next
  std::uint8_t before = 0;  ///< its neighbours, on this side of the edge
  std::uint8_t after = 0;

  EntryPlace() = default;
  /// Vertices `first` to `first + count - 1` of a ring of `other_size` lie beyond the edge that
  /// begins at vertex `edge` of a ring of `ring_size`.
  EntryPlace(std::size_t ring_size, std::size_t edge, std::size_t other_size, std::size_t first,
             std::size_t count)
      : ring_size(number(ring_size)), other_size(number(other_size)), edge(number(edge)),
        edge_end(number(next_vertex(edge, ring_size))),
        across(number((edge + ring_size / 2 + 1) % ring_size)), first(number(first)),
        last(count == 1 ? number(first) : number(next_vertex(first, other_size))),
        before(number(previous_vertex(first, other_size))),
        after(number(next_vertex(last, other_size))) {}

  /// Whether rings are of the sizes that it was made for.
  [[nodiscard]] bool fits(Ring ring, Ring other) const {
    return ring.size() == ring_size && other.size() == other_size;
  }

 private:
  [[nodiscard]] static std::uint8_t number(std::size_t k) { return static_cast<std::uint8_t>(k); }
};

/// The cap of `other` at a place, if it is all that the two convex rings have in common: the
/// boundaries cross twice, both times on that edge. A corner or a face in an edge is the commonest
/// contact of polygons, and from one step to the next it stays where it is. That the vertices
/// before and after lie outside is enough to know that all others do, so nothing is searched: 12 ns
/// against 110 of clipping. Nothing where all that is not so by a clear margin, 1e-8 of the edge's
/// length: far above the round-off of coordinates, so that exact arithmetic would agree. Only where
/// a long side nearly grazes a short edge can the crossing's own error be larger.
[[nodiscard]] inline std::optional<EdgeCap> edge_cap(Ring ring, Ring other,
                                                     const EntryPlace& place) {
  constexpr double margin = 1e-8;
  const Vec2& p = ring[place.edge];
  const Vec2& q = ring[place.edge_end];
  const Vec2& in_1 = other[place.first];
  const Vec2& in_2 = other[place.last];
  const Vec2& before = other[place.before];
  const Vec2& after = other[place.after];

  // Where the boundary goes in and where it comes out, side by side: half the instructions.
  using Pair = Eigen::Array2d;
  const LineSide edge(p, q);
  const Pair in_x = Pair(in_1.x(), in_2.x()) - p.x();
  const Pair in_y = Pair(in_1.y(), in_2.y()) - p.y();
  const Pair out_x = Pair(before.x(), after.x()) - p.x();
  const Pair out_y = Pair(before.y(), after.y()) - p.y();
  const Pair deep = edge.x * in_y - edge.y * in_x;
  const Pair high = edge.y * out_x - edge.x * out_y;
  const Pair in_along = edge.x * in_x + edge.y * in_y;
  const Pair out_along = edge.x * out_x + edge.y * out_y;
  const Pair crossing = in_along + deep / (deep + high) * (out_along - in_along);
  const double entered = crossing[0];
  const double left = crossing[1];
  const double squared = edge.x * edge.x + edge.y * edge.y;
  const double clear = margin * squared;
  // One after the other these would be seven branches.
  const double across = deep.min(high).minCoeff();
  const double on_edge = std::min(std::min(left, entered - left), squared - entered);
  if (!(std::min(across, on_edge) > clear)) return std::nullopt;

  const double length = std::sqrt(squared);
  const TriangleAcross triangle(ring[place.across], edge, 2 * margin);
  const auto inside = [&](const Vec2& v, double depth) {
    return triangle.holds(v, depth) || inside_other_edges(ring, place.edge, v, margin * length);
  };
  if (!inside(in_1, deep[0])) return std::nullopt;
  const double scale = 1 / length;
  const double middle = 0.5 * (entered + left) * scale * scale;
  EdgeCap cap{.normal = {edge.y * scale, -edge.x * scale},
              .middle = {p.x() + middle * edge.x, p.y() + middle * edge.y},
              .depth = deep[0] * scale,
              .chord = (entered - left) * scale};
  if (place.first == place.last) {
    cap.area = 0.5 * cap.chord * cap.depth;
  } else {
    if (!inside(in_2, deep[1])) return std::nullopt;
    cap.depth = deep.maxCoeff() * scale;
    cap.area =
        0.5 * scale * scale * ((in_along[0] - left) * deep[1] + (entered - in_along[1]) * deep[0]);
  }
  return cap;
}

}  // namespace riprap
