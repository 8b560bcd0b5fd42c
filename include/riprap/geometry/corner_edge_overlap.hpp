// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Overlap of one or two corners of a convex ring with a single edge of another, in closed form.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

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
#ifdef __AVX__
inline constexpr std::size_t simd_lanes = 4;
#else
inline constexpr std::size_t simd_lanes = 2;
#endif
using CornerEdgeQueries = std::array<CornerEdgeQuery, simd_lanes>;

namespace internal {

using Lanes = Eigen::Array<double, simd_lanes, 1>;

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
    if constexpr (simd_lanes == 2) {
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
  using internal::VertexLanes;
  constexpr double margin = 1e-8;
  const VertexLanes start(queries, &CornerEdgeQuery::ring, &Feature::edge);
  const VertexLanes edge({queries, &CornerEdgeQuery::ring, &Feature::edge_end}, start);
  const Numbers squared = edge.x * edge.x + edge.y * edge.y;
  const CrossingLanes in(queries, start, edge, &Feature::first, &Feature::before);
  const CrossingLanes out(queries, start, edge, &Feature::last, &Feature::after);
  const Numbers width = in.along - out.along;
  const Numbers least = in.deep.min(in.high)
                            .min(out.deep.min(out.high))
                            .min(out.along.min(width.min(squared - in.along)));
  const Numbers clear = margin * squared;

  // The triangle of the edge and the opposite vertex contains most points inside the ring near the
  // edge, and testing it is cheaper than testing all edges.
  const VertexLanes opposite({queries, &CornerEdgeQuery::ring, &Feature::opposite}, start);
  const Numbers twice_area = edge.x * opposite.y - edge.y * opposite.x;
  const Numbers left_in = in.inside.x * opposite.y - in.inside.y * opposite.x;
  const Numbers left_out = out.inside.x * opposite.y - out.inside.y * opposite.x;
  // No less than the square of the sum of the lengths of two sides.
  const Numbers size = 4 * (squared + opposite.x * opposite.x + opposite.y * opposite.y);
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
  const auto report = [&]<Eigen::Index k>(std::integral_constant<Eigen::Index, k>)
      __attribute__((always_inline)) {
    constexpr auto l = static_cast<std::size_t>(k);
    const bool crossed = least[k] > clear[k];
    if (!crossed) return;
    if (!(inside[k] > 0) && !internal::inside_all(queries[l], margin * length[k])) return;
    const bool one_vertex = queries[l].place->one_vertex();
    found(l, CornerEdgeOverlap{.normal = {normal_x[k], normal_y[k]},
                               .middle = {middle_x[k], middle_y[k]},
                               .depth = depth[k],
                               .area = one_vertex ? 0.5 * chord[k] * depth[k] : quadrangle[k],
                               .chord = chord[k],
                               .one_vertex = one_vertex});
  };
  [&]<std::size_t... l>(std::index_sequence<l...>) __attribute__((always_inline)) {
    (report(std::integral_constant<Eigen::Index, l>{}), ...);
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
