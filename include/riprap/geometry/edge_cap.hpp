// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What one convex ring has inside another where it enters through a single edge.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/entry_place.hpp>
#include <riprap/geometry/line_side.hpp>

namespace riprap {

/// The part of a convex ring that lies beyond one edge of another. Its base is the chord on the
/// edge from where the boundary of the entering ring comes out to where it goes in.
struct EdgeCap {
  Vec2 normal{1, 0};       ///< of the edge, outwards
  Vec2 middle{0, 0};       ///< of the chord
  double depth = 0;        ///< of the deepest vertex below the edge [m]
  double area = 0;         ///< [m^2]
  double chord = 0;        ///< its length [m]
  bool one_vertex = true;  ///< one lies beyond the edge, and not two
};

/// Two rings, and where the cap of `other` in `ring` is if they have one. The place fits the rings.
struct CapQuestion {
  const Vec2* ring;
  const Vec2* other;
  const EntryPlace* place;
};

/// How many caps are found side by side: as many as a vector register has doubles. Each is computed
/// as if it were alone, so that results do not depend on their number.
#ifdef __AVX__
inline constexpr std::size_t cap_lanes = 4;
#else
inline constexpr std::size_t cap_lanes = 2;
#endif
using CapQuestions = std::array<CapQuestion, cap_lanes>;

namespace internal {

using CapLanes = Eigen::Array<double, cap_lanes, 1>;

// A vertex of every question, from some origin. Always inlined: handed on through memory they would
// cost what is saved.
struct VertexLanes {
  CapLanes x, y;

  [[gnu::always_inline]] VertexLanes(const CapQuestions& questions, const Vec2* CapQuestion::*ring,
                                     std::uint8_t EntryPlace::*vertex) {
    const auto at = [&](std::size_t l) __attribute__((always_inline))->const Vec2& {
      return (questions[l].*ring)[questions[l].place->*vertex];
    };
    if constexpr (cap_lanes == 2) {
      x = {at(0).x(), at(1).x()};
      y = {at(0).y(), at(1).y()};
    } else {
      x = {at(0).x(), at(1).x(), at(2).x(), at(3).x()};
      y = {at(0).y(), at(1).y(), at(2).y(), at(3).y()};
    }
  }
  [[gnu::always_inline]] VertexLanes(const VertexLanes& v, const VertexLanes& origin)
      : x(v.x - origin.x), y(v.y - origin.y) {}
};

// Where the boundary crosses the edge, going in or coming out. All but `inside` times the edge's
// length.
struct CrossingLanes {
  VertexLanes inside;     // the vertex beyond the edge
  CapLanes deep;          // how far it lies beyond
  CapLanes high;          // how far its neighbour lies on this side
  CapLanes inside_along;  // along the edge, from its start
  CapLanes along;         // the crossing, likewise

  [[gnu::always_inline]] CrossingLanes(const CapQuestions& questions, const VertexLanes& start,
                                       const VertexLanes& edge, std::uint8_t EntryPlace::*beyond,
                                       std::uint8_t EntryPlace::*neighbour)
      : inside({questions, &CapQuestion::other, beyond}, start) {
    const VertexLanes outside({questions, &CapQuestion::other, neighbour}, start);
    deep = edge.x * inside.y - edge.y * inside.x;
    high = edge.y * outside.x - edge.x * outside.y;
    inside_along = edge.x * inside.x + edge.y * inside.y;
    const CapLanes outside_along = edge.x * outside.x + edge.y * outside.y;
    along = inside_along + deep / (deep + high) * (outside_along - inside_along);
  }
};

// Whether what lies beyond the edge lies inside all others.
[[nodiscard]] inline bool inside_all(const CapQuestion& q, double margin) {
  const Ring ring{q.ring, q.place->ring_size};
  return inside_other_edges(ring, q.place->edge, q.other[q.place->first], margin) &&
         inside_other_edges(ring, q.place->edge, q.other[q.place->last], margin);
}

}  // namespace internal

/// The caps at given places, where that is all that the two convex rings of a question have in
/// common: the boundaries cross twice, both times on that edge. A corner or a face in an edge is
/// the commonest contact of polygons, and from one step to the next it stays where it is. That the
/// vertices before and after lie outside is enough to know that all others do, so nothing is
/// searched. Found only where all that is so by a clear margin, 1e-8 of the edge's length: far
/// above the round-off of coordinates, so that exact arithmetic would agree. Only where a long side
/// nearly grazes a short edge can the crossing's own error be larger.
/// @param found called with the number of every question that has a cap, and the cap
template <class Found>
[[gnu::flatten]] void find_edge_caps(const CapQuestions& questions, Found&& found) {
  using Numbers = internal::CapLanes;
  using internal::CrossingLanes;
  using internal::VertexLanes;
  constexpr double margin = 1e-8;
  const VertexLanes start(questions, &CapQuestion::ring, &EntryPlace::edge);
  const VertexLanes edge({questions, &CapQuestion::ring, &EntryPlace::edge_end}, start);
  const Numbers squared = edge.x * edge.x + edge.y * edge.y;
  const CrossingLanes in(questions, start, edge, &EntryPlace::first, &EntryPlace::before);
  const CrossingLanes out(questions, start, edge, &EntryPlace::last, &EntryPlace::after);
  const Numbers width = in.along - out.along;
  const Numbers least = in.deep.min(in.high)
                            .min(out.deep.min(out.high))
                            .min(out.along.min(width.min(squared - in.along)));
  const Numbers clear = margin * squared;

  // The triangle over the edge to a vertex across holds most of what lies inside the ring near the
  // edge, and to ask it costs a third of asking all edges.
  const VertexLanes across({questions, &CapQuestion::ring, &EntryPlace::across}, start);
  const Numbers twice_area = edge.x * across.y - edge.y * across.x;
  const Numbers left_in = in.inside.x * across.y - in.inside.y * across.x;
  const Numbers left_out = out.inside.x * across.y - out.inside.y * across.x;
  // No less than the square of the sum of the lengths of two sides.
  const Numbers size = 4 * (squared + across.x * across.x + across.y * across.y);
  const Numbers inside = left_in.min(twice_area - in.deep - left_in)
                             .min(left_out.min(twice_area - out.deep - left_out)) -
                         2 * margin * size;

  const Numbers length = squared.sqrt();
  const Numbers scale = length.inverse();
  const Numbers middle = 0.5 * (in.along + out.along) * scale * scale;
  const Numbers normal_x = edge.y * scale;
  const Numbers normal_y = -edge.x * scale;
  const Numbers middle_x = start.x + middle * edge.x;
  const Numbers middle_y = start.y + middle * edge.y;
  const Numbers depth = in.deep.max(out.deep) * scale;
  const Numbers chord = width * scale;
  const Numbers quadrangle =
      0.5 * scale * scale *
      ((in.inside_along - out.along) * out.deep + (in.along - out.inside_along) * in.deep);
  const auto tell = [&]<Eigen::Index k>(std::integral_constant<Eigen::Index, k>)
      __attribute__((always_inline)) {
    constexpr auto l = static_cast<std::size_t>(k);
    const bool crossed = least[k] > clear[k];
    if (!crossed) return;
    if (!(inside[k] > 0) && !internal::inside_all(questions[l], margin * length[k])) return;
    const bool one_vertex = questions[l].place->one_vertex();
    found(l, EdgeCap{.normal = {normal_x[k], normal_y[k]},
                     .middle = {middle_x[k], middle_y[k]},
                     .depth = depth[k],
                     .area = one_vertex ? 0.5 * chord[k] * depth[k] : quadrangle[k],
                     .chord = chord[k],
                     .one_vertex = one_vertex});
  };
  [&]<std::size_t... l>(std::index_sequence<l...>) __attribute__((always_inline)) {
    (tell(std::integral_constant<Eigen::Index, l>{}), ...);
  }
  (std::make_index_sequence<cap_lanes>{});
}

/// The cap of a single question, or nothing.
[[nodiscard]] inline std::optional<EdgeCap> edge_cap(Ring ring, Ring other,
                                                     const EntryPlace& place) {
  if (!place.fits(ring, other)) return std::nullopt;
  CapQuestions questions;
  questions.fill({ring.data(), other.data(), &place});
  std::optional<EdgeCap> cap;
  find_edge_caps(questions, [&](std::size_t l, const EdgeCap& one) {
    if (l == 0) cap = one;
  });
  return cap;
}

}  // namespace riprap
