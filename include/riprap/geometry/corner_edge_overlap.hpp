// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Overlap of one or two corners of a convex ring with a single edge of another, in closed form.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include <riprap/core/lanes.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/geometry/corner_edge_feature.hpp>
#include <riprap/geometry/line_side.hpp>

namespace riprap {

/// The part of a convex ring that lies beyond one edge of another. Its base is the chord on the
/// edge from where the boundary of the entering ring comes out to where it goes in.
struct CornerEdgeOverlap {
  Vec2 normal{1, 0};       ///< of the edge, outwards
  Vec2 middle{0, 0};       ///< of the chord
  double depth = 0;        ///< of the deepest vertex below the edge [m]
  double area = 0;         ///< [m^2]
  double chord = 0;        ///< its length [m]
  bool one_vertex = true;  ///< one lies beyond the edge, and not two
};

/// Two rings, and the feature at which `other` overlaps `ring`. The feature must fit the rings.
struct CornerEdgeQuery {
  const Vec2* ring;
  const Vec2* other;
  const CornerEdgeFeature* place;
};

/// Number of overlaps evaluated at once (SIMD): that of doubles in a vector register. Each lane
/// computes what a scalar evaluation would, so that results do not depend on the number.
inline constexpr std::size_t simd_lanes = internal::double_lanes;
using CornerEdgeQueries = std::array<CornerEdgeQuery, simd_lanes>;

namespace internal {

using Lanes = DoubleLanes;

// A vertex of every query, relative to an origin. Always inlined: passed through memory, the lanes
// would cost what they save.
struct VertexLanes {
  Lanes x, y;

  [[gnu::always_inline]] VertexLanes(const CornerEdgeQueries& queries,
                                     const Vec2* CornerEdgeQuery::*ring,
                                     std::uint8_t CornerEdgeFeature::*vertex) {
    const auto at = [&](std::size_t l) __attribute__((always_inline))->const Vec2& {
      return (queries[l].*ring)[queries[l].place->*vertex];
    };
#ifndef __AVX__
    x = Lanes{at(0).x(), at(1).x()};
    y = Lanes{at(0).y(), at(1).y()};
#else
    x = Lanes{at(0).x(), at(1).x(), at(2).x(), at(3).x()};
    y = Lanes{at(0).y(), at(1).y(), at(2).y(), at(3).y()};
#endif
  }
  [[gnu::always_inline]] VertexLanes(const VertexLanes& v, const VertexLanes& origin)
      : x(v.x - origin.x), y(v.y - origin.y) {}
};

// Where the boundary crosses the edge, going in or coming out. All but `inside` times the edge's
// length.
struct CrossingLanes {
  VertexLanes inside;  // the vertex beyond the edge
  Lanes deep;          // how far it lies beyond
  Lanes high;          // how far its neighbour lies on this side
  Lanes inside_along;  // along the edge, from its start
  Lanes along;         // the crossing, likewise

  [[gnu::always_inline]] CrossingLanes(const CornerEdgeQueries& queries, const VertexLanes& start,
                                       const VertexLanes& edge,
                                       std::uint8_t CornerEdgeFeature::*beyond,
                                       std::uint8_t CornerEdgeFeature::*neighbour)
      : inside({queries, &CornerEdgeQuery::other, beyond}, start) {
    const VertexLanes outside({queries, &CornerEdgeQuery::other, neighbour}, start);
    deep = edge.x * inside.y - edge.y * inside.x;
    high = edge.y * outside.x - edge.x * outside.y;
    inside_along = edge.x * inside.x + edge.y * inside.y;
    const Lanes outside_along = edge.x * outside.x + edge.y * outside.y;
    along = inside_along + deep / (deep + high) * (outside_along - inside_along);
  }
};

// Whether the vertices beyond the edge lie inside all other edges.
[[nodiscard]] inline bool inside_all(const CornerEdgeQuery& q, double margin) {
  const Ring ring{q.ring, q.place->ring_size};
  return inside_other_edges(ring, q.place->edge, q.other[q.place->first], margin) &&
         inside_other_edges(ring, q.place->edge, q.other[q.place->last], margin);
}

}  // namespace internal

/// Overlaps at the given features, if the overlap of the two convex rings consists of that alone:
/// the boundaries cross twice, both times on the edge. A corner or a face in an edge is the most
/// common contact of polygons, and its feature rarely changes from one step to the next. By
/// convexity all other vertices lie outside if the two next to the corners do. Reported only if all
/// conditions hold by a margin of 1e-8 of the edge's length: far above the round-off of
/// coordinates, so that exact arithmetic would agree. Only where a long side nearly grazes a short
/// edge can the error of the crossing be larger.
/// @param found called with the index of every query that has an overlap, and the overlap
template <class Found>
[[gnu::flatten]] void find_corner_edge_overlaps(const CornerEdgeQueries& queries, Found&& found) {
  using Feature = CornerEdgeFeature;
  using Numbers = internal::Lanes;
  using internal::CrossingLanes;
  using internal::largest_of;
  using internal::least_of;
  using internal::square_root_of;
  using internal::VertexLanes;
  constexpr double margin = 1e-8;
  const VertexLanes start(queries, &CornerEdgeQuery::ring, &Feature::edge);
  const VertexLanes edge({queries, &CornerEdgeQuery::ring, &Feature::edge_end}, start);
  const Numbers squared = edge.x * edge.x + edge.y * edge.y;
  const CrossingLanes in(queries, start, edge, &Feature::first, &Feature::before);
  const CrossingLanes out(queries, start, edge, &Feature::last, &Feature::after);
  const Numbers width = in.along - out.along;
  const Numbers least = least_of(least_of(least_of(in.deep, in.high), least_of(out.deep, out.high)),
                                 least_of(out.along, least_of(width, squared - in.along)));
  const Numbers clear = margin * squared;

  // The triangle of the edge and the opposite vertex contains most points inside the ring near the
  // edge, and testing it is cheaper than testing all edges.
  const VertexLanes opposite({queries, &CornerEdgeQuery::ring, &Feature::opposite}, start);
  const Numbers twice_area = edge.x * opposite.y - edge.y * opposite.x;
  const Numbers left_in = in.inside.x * opposite.y - in.inside.y * opposite.x;
  const Numbers left_out = out.inside.x * opposite.y - out.inside.y * opposite.x;
  // No less than the square of the sum of the lengths of two sides.
  const Numbers size = 4 * (squared + opposite.x * opposite.x + opposite.y * opposite.y);
  const Numbers inside = least_of(least_of(left_in, twice_area - in.deep - left_in),
                                  least_of(left_out, twice_area - out.deep - left_out)) -
                         2 * margin * size;

  const Numbers length = square_root_of(squared);
  const Numbers scale = 1 / length;
  const Numbers middle = 0.5 * (in.along + out.along) * scale * scale;
  const Numbers normal_x = edge.y * scale;
  const Numbers normal_y = -edge.x * scale;
  const Numbers middle_x = start.x + middle * edge.x;
  const Numbers middle_y = start.y + middle * edge.y;
  const Numbers depth = largest_of(in.deep, out.deep) * scale;
  const Numbers chord = width * scale;
  const Numbers quadrangle =
      0.5 * scale * scale *
      ((in.inside_along - out.along) * out.deep + (in.along - out.inside_along) * in.deep);
  const auto report = [&]<std::size_t l>(std::integral_constant<std::size_t, l>)
      __attribute__((always_inline)) {
    const bool crossed = least[l] > clear[l];
    if (!crossed) return;
    if (!(inside[l] > 0) && !internal::inside_all(queries[l], margin * length[l])) return;
    const bool one_vertex = queries[l].place->one_vertex();
    found(l, CornerEdgeOverlap{.normal = {normal_x[l], normal_y[l]},
                               .middle = {middle_x[l], middle_y[l]},
                               .depth = depth[l],
                               .area = one_vertex ? 0.5 * chord[l] * depth[l] : quadrangle[l],
                               .chord = chord[l],
                               .one_vertex = one_vertex});
  };
  [&]<std::size_t... l>(std::index_sequence<l...>) __attribute__((always_inline)) {
    (report(std::integral_constant<std::size_t, l>{}), ...);
  }
  (std::make_index_sequence<simd_lanes>{});
}

/// The cap of a single question, or nothing.
[[nodiscard]] inline std::optional<CornerEdgeOverlap>
corner_edge_overlap(Ring ring, Ring other, const CornerEdgeFeature& place) {
  if (!place.fits(ring, other)) return std::nullopt;
  CornerEdgeQueries queries;
  queries.fill({ring.data(), other.data(), &place});
  std::optional<CornerEdgeOverlap> cap;
  find_corner_edge_overlaps(queries, [&](std::size_t l, const CornerEdgeOverlap& one) {
    if (l == 0) cap = one;
  });
  return cap;
}

}  // namespace riprap
