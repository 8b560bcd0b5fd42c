// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Overlap of one or two corners of a convex ring with a single edge of another, in closed form.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include <riprap/core/simd.hpp>
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

namespace internal {

// The formula is written once, for numbers of type N: a double, or several of them (SIMD). Always
// inlined: passed through memory, vectors would cost what they save.

// A vertex of every query, relative to an origin.
template <class N>
struct QueryVertex {
  N x, y;

  [[gnu::always_inline]] QueryVertex(const CornerEdgeQuery* queries,
                                     const Vec2* CornerEdgeQuery::*ring,
                                     std::uint8_t CornerEdgeFeature::*vertex) {
    const auto at = [&](std::size_t l) __attribute__((always_inline))->const Vec2& {
      return (queries[l].*ring)[queries[l].place->*vertex];
    };
    x = gather_lanes<N>([&](std::size_t l) __attribute__((always_inline)) { return at(l).x(); });
    y = gather_lanes<N>([&](std::size_t l) __attribute__((always_inline)) { return at(l).y(); });
  }
  [[gnu::always_inline]] QueryVertex(const QueryVertex& v, const QueryVertex& origin)
      : x(v.x - origin.x), y(v.y - origin.y) {}
};

// Where the boundary crosses the edge, going in or coming out. All but `inside` times the edge's
// length.
template <class N>
struct EdgeCrossing {
  QueryVertex<N> inside;  // the vertex beyond the edge
  N deep;                 // how far it lies beyond
  N high;                 // how far its neighbour lies on this side
  N inside_along;         // along the edge, from its start
  N further;              // from there to the crossing
  N along;                // the crossing, from the edge's start

  [[gnu::always_inline]] EdgeCrossing(const CornerEdgeQuery* queries, const QueryVertex<N>& start,
                                      const QueryVertex<N>& edge,
                                      std::uint8_t CornerEdgeFeature::*beyond,
                                      std::uint8_t CornerEdgeFeature::*neighbour)
      : inside({queries, &CornerEdgeQuery::other, beyond}, start) {
    const QueryVertex<N> outside({queries, &CornerEdgeQuery::other, neighbour}, start);
    deep = edge.x * inside.y - edge.y * inside.x;
    high = edge.y * outside.x - edge.x * outside.y;
    inside_along = edge.x * inside.x + edge.y * inside.y;
    const N outside_along = edge.x * outside.x + edge.y * outside.y;
    further = deep / (deep + high) * (outside_along - inside_along);
    along = inside_along + further;
  }
};

// Whether the vertices beyond the edge lie inside all other edges.
[[nodiscard]] inline bool inside_all(const CornerEdgeQuery& q, double margin) {
  const Ring ring{q.ring, q.place->ring_size};
  return inside_other_edges(ring, q.place->edge, q.other[q.place->first], margin) &&
         inside_other_edges(ring, q.place->edge, q.other[q.place->last], margin);
}

// Conditions of an overlap at the features of as many queries as N has lanes, and the crossings.
template <class N>
struct EdgeCap {
  using Feature = CornerEdgeFeature;

  QueryVertex<N> start;  // of the edge
  QueryVertex<N> edge;   // its end, relative to the start
  N squared;             // length of the edge
  EdgeCrossing<N> in;    // of the boundary of `other`, counter-clockwise
  EdgeCrossing<N> out;
  N width = in.along - out.along;
  N length = square_root(squared);
  N scale = 1 / length;
  bool has_faces = false;  // two vertices lie beyond the edge, in one of the queries at least

  [[gnu::always_inline]] explicit EdgeCap(const CornerEdgeQuery* queries)
      : start(queries, &CornerEdgeQuery::ring, &Feature::edge),
        edge({queries, &CornerEdgeQuery::ring, &Feature::edge_end}, start),
        squared(edge.x * edge.x + edge.y * edge.y),
        in(queries, start, edge, &Feature::first, &Feature::before),
        out(queries, start, edge, &Feature::last, &Feature::after) {
    for (std::size_t l = 0; l < lanes_of<N>; ++l) has_faces |= !queries[l].place->one_vertex();
  }

  // Above margin * squared: the boundary crosses the edge twice, clearly within its ends.
  [[nodiscard, gnu::always_inline]] N crossing() const {
    return smaller(smaller(smaller(in.deep, in.high), smaller(out.deep, out.high)),
                   smaller(out.along, smaller(width, N(squared - in.along))));
  }
  // Above zero: the vertices beyond the edge are clearly inside the triangle of the edge and the
  // opposite vertex. It contains most points inside the ring near the edge, and testing it is
  // cheaper than testing all edges.
  [[nodiscard, gnu::always_inline]] N inside_triangle(const CornerEdgeQuery* queries,
                                                      double margin) const {
    const QueryVertex<N> opposite({queries, &CornerEdgeQuery::ring, &Feature::opposite}, start);
    const N twice_area = edge.x * opposite.y - edge.y * opposite.x;
    const N left_in = in.inside.x * opposite.y - in.inside.y * opposite.x;
    const N left_out = out.inside.x * opposite.y - out.inside.y * opposite.x;
    // No less than the square of the sum of the lengths of two sides.
    const N size = 4 * (squared + opposite.x * opposite.x + opposite.y * opposite.y);
    return smaller(smaller(left_in, N(twice_area - in.deep - left_in)),
                   smaller(left_out, N(twice_area - out.deep - left_out))) -
           2 * margin * size;
  }
};

// The overlaps at the features of as many queries as N has lanes.
template <class N>
struct CornerEdgeOverlaps {
  N normal_x, normal_y, middle_x, middle_y, depth, chord, quadrangle;

  [[gnu::always_inline]] explicit CornerEdgeOverlaps(const EdgeCap<N>& cap) {
    const auto& [start, edge, squared, in, out, width, length, scale, has_faces] = cap;
    const N middle = 0.5 * (in.along + out.along) * scale * scale;
    normal_x = edge.y * scale;
    normal_y = -edge.x * scale;
    middle_x = start.x + middle * edge.x;
    middle_y = start.y + middle * edge.y;
    depth = larger(in.deep, out.deep) * scale;
    chord = width * scale;
    quadrangle =
        0.5 * scale * scale *
        ((in.inside_along - out.along) * out.deep + (in.along - out.inside_along) * in.deep);
  }
  [[nodiscard, gnu::always_inline]] CornerEdgeOverlap overlap(std::size_t l,
                                                              bool one_vertex) const {
    return {.normal = {lane(normal_x, l), lane(normal_y, l)},
            .middle = {lane(middle_x, l), lane(middle_y, l)},
            .depth = lane(depth, l),
            .area = one_vertex ? 0.5 * lane(chord, l) * lane(depth, l) : lane(quadrangle, l),
            .chord = lane(chord, l),
            .one_vertex = one_vertex};
  }
};

// Calls `found` with the overlap of each query that has one; as many queries as N has lanes.
template <class N, template <class> class Overlaps, class Found>
[[gnu::always_inline]] inline void find_corner_edge_overlaps(const CornerEdgeQuery* queries,
                                                             Found&& found) {
  constexpr double margin = 1e-8;
  const EdgeCap<N> cap(queries);
  const N crossing = cap.crossing();
  const N clear = margin * cap.squared;
  const N inside = cap.inside_triangle(queries, margin);
  const Overlaps<N> overlaps(cap);
  const auto report = [&](std::size_t l) __attribute__((always_inline)) {
    if (!(lane(crossing, l) > lane(clear, l))) return;
    if (!(lane(inside, l) > 0) && !inside_all(queries[l], margin * lane(cap.length, l))) return;
    found(l, overlaps.overlap(l, queries[l].place->one_vertex()));
  };
  // Not a loop, so that every lane is a constant.
  report(0);
  if constexpr (lanes_of<N> > 1) report(1);
  if constexpr (lanes_of<N> > 2) {
    report(2);
    report(3);
  }
}

}  // namespace internal

/// Overlaps at the given features, if the overlap of the two convex rings consists of that alone:
/// the boundaries cross twice, both times on the edge. A corner or a face in an edge is the most
/// common contact of polygons, and its feature rarely changes from one step to the next. By
/// convexity all other vertices lie outside if the two next to the corners do. Reported only if all
/// conditions hold by a margin of 1e-8 of the edge's length: far above the round-off of
/// coordinates, so that exact arithmetic would agree. Only where a long side nearly grazes a short
/// edge can the error of the crossing be larger.
/// @tparam lanes number of overlaps evaluated at once (SIMD); results do not depend on it
/// @tparam Overlaps what is evaluated, for a number type: from an internal::EdgeCap
/// @param found called with the index of every query that has an overlap, and the overlap
template <std::size_t lanes = native_lanes,
          template <class> class Overlaps = internal::CornerEdgeOverlaps, std::size_t count,
          class Found>
[[gnu::flatten]] void find_corner_edge_overlaps(const std::array<CornerEdgeQuery, count>& queries,
                                                Found&& found) {
  static_assert(count % lanes == 0);
  for (std::size_t first = 0; first < count; first += lanes)
    internal::find_corner_edge_overlaps<Simd<double, lanes>, Overlaps>(
        queries.data() + first, [&](std::size_t l, const auto& overlap)
                                    __attribute__((always_inline)) { found(first + l, overlap); });
}

/// The overlap at one feature, or nothing.
template <template <class> class Overlaps = internal::CornerEdgeOverlaps>
[[nodiscard, gnu::flatten]] auto corner_edge_overlap(Ring ring, Ring other,
                                                     const CornerEdgeFeature& place) {
  std::optional<decltype(std::declval<const Overlaps<double>&>().overlap(0, true))> found;
  if (!place.fits(ring, other)) return found;
  const CornerEdgeQuery query{ring.data(), other.data(), &place};
  internal::find_corner_edge_overlaps<double, Overlaps>(
      &query, [&](std::size_t, const auto& overlap) { found = overlap; });
  return found;
}

}  // namespace riprap
