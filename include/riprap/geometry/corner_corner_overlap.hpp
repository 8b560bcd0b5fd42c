// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What two convex rings have in common where a corner of each lies in the other.

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include <riprap/core/simd.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/geometry/line_side.hpp>

namespace riprap {

/// A quadrangle with one corner from each of two rings; the other two are the crossings of their
/// boundaries.
struct CornerCornerOverlap {
  Vec2 leaves_a{0, 0};  ///< crossing after a's corner, going round counter-clockwise ...
  Vec2 enters_a{0, 0};  ///< ... and before it
  double area = 0;      ///< [m^2]
};

/// Vertex `i` of ring a and vertex `j` of ring b.
struct CornerCornerQuery {
  Ring a, b;
  std::size_t i, j;
  double margin;  ///< by which conditions have to hold [m]
};

namespace internal {

/// Does v, between the two edges at vertex `j` of a convex ring, lie inside all others as well, by
/// a clear margin [m]?
[[nodiscard]] inline bool inside_beyond_corner(Ring ring, std::size_t j, const Vec2& v,
                                               double margin) {
  const std::size_t n = ring.size();
  const std::size_t before = previous_vertex(j, n);
  for (std::size_t k = 0; k < n; ++k)
    if (k != j && k != before &&
        !LineSide(ring[k], ring[next_vertex(k, n)]).lies_left_by(v, margin))
      return false;
  return true;
}

// The formula is written once, for numbers of type N, as that of corner-edge overlaps.

// A corner of every query and its neighbours.
template <class N>
struct QueryCorner {
  struct Point {
    N x, y;
  };
  Point at, next, before;

  [[gnu::always_inline]] QueryCorner(const CornerCornerQuery* queries,
                                     Ring CornerCornerQuery::*ring,
                                     std::size_t CornerCornerQuery::*vertex)
      : at(gather(queries, ring, [&](std::size_t l) { return queries[l].*vertex; })),
        next(gather(queries, ring,
                    [&](std::size_t l) {
                      return next_vertex(queries[l].*vertex, (queries[l].*ring).size());
                    })),
        before(gather(queries, ring, [&](std::size_t l) {
          return previous_vertex(queries[l].*vertex, (queries[l].*ring).size());
        })) {}

 private:
  template <class Vertex>
  [[gnu::always_inline]] static Point gather(const CornerCornerQuery* queries,
                                             Ring CornerCornerQuery::*ring, Vertex&& vertex) {
    const auto v = [&](std::size_t l) __attribute__((always_inline))->const Vec2& {
      return (queries[l].*ring)[vertex(l)];
    };
    return {
        gather_lanes<N>([&](std::size_t l) __attribute__((always_inline)) { return v(l).x(); }),
        gather_lanes<N>([&](std::size_t l) __attribute__((always_inline)) { return v(l).y(); })};
  }
};

// A line for every query; as LineSide.
template <class N>
struct QueryLine {
  using Point = typename QueryCorner<N>::Point;
  N x, y, from_x, from_y;

  [[gnu::always_inline]] QueryLine(const Point& p, const Point& q)
      : x(q.x - p.x), y(q.y - p.y), from_x(p.x), from_y(p.y) {}
  [[nodiscard, gnu::always_inline]] N operator()(const Point& v) const {
    return x * (v.y - from_y) - y * (v.x - from_x);
  }
  [[nodiscard, gnu::always_inline]] N length_bound() const { return magnitude(x) + magnitude(y); }
};

// Conditions of an overlap at the corners of as many queries as N has lanes, and the crossings.
template <class N>
struct CornerLens {
  using Point = typename QueryCorner<N>::Point;

  QueryCorner<N> p, q;  // of a and of b
  Point leaves, enters;
  N at_leaves, at_enters;  // twice the areas of the triangles that the line p q cuts off there
  N crossing;              // above zero: the edge out of p crosses the edge into q, and vice versa
  N inside_a;              // above zero: q clearly inside the triangle of p and its neighbours
  N inside_b;              // likewise

  [[gnu::always_inline]] explicit CornerLens(const CornerCornerQuery* queries)
      : p(queries, &CornerCornerQuery::a, &CornerCornerQuery::i),
        q(queries, &CornerCornerQuery::b, &CornerCornerQuery::j) {
    const N margin = gather_lanes<N>([&](std::size_t l) __attribute__((always_inline)) {
      return queries[l].margin;
    });
    const QueryLine<N> out_of_p(p.at, p.next);
    const QueryLine<N> into_p(p.before, p.at);
    const QueryLine<N> out_of_q(q.at, q.next);
    const QueryLine<N> into_q(q.before, q.at);
    const N p_left = out_of_q(p.at);
    const N q_left = out_of_p(q.at);
    const N p_deep = into_q(p.at);
    const N p_out = into_q(p.next);
    const N q_deep = into_p(q.at);
    const N q_out = into_p(q.next);
    const auto beyond =
        [](const N& inside, const N& outside, const N& by) __attribute__((always_inline)) {
      return smaller(N(inside - by), N(-outside - by));
    };
    crossing =
        smaller(smaller(beyond(p_deep, p_out, margin * into_q.length_bound()),
                        beyond(q_deep, q_out, margin * into_p.length_bound())),
                smaller(beyond(q_left, out_of_p(q.before), margin * out_of_p.length_bound()),
                        beyond(p_left, out_of_q(p.before), margin * out_of_q.length_bound())));
    const N wide = 1.5 * margin;
    const QueryLine<N> across_a(p.next, p.before);
    const QueryLine<N> across_b(q.next, q.before);
    inside_a = across_a(q.at) - wide * across_a.length_bound();
    inside_b = across_b(p.at) - wide * across_b.length_bound();
    const N along_p = p_deep / (p_deep - p_out);
    const N along_q = q_deep / (q_deep - q_out);
    at_leaves = along_p * q_left;
    at_enters = along_q * p_left;
    leaves = {p.at.x + along_p * (p.next.x - p.at.x), p.at.y + along_p * (p.next.y - p.at.y)};
    enters = {q.at.x + along_q * (q.next.x - q.at.x), q.at.y + along_q * (q.next.y - q.at.y)};
  }
};

// The overlaps at the corners of as many queries as N has lanes.
template <class N>
struct CornerCornerOverlaps {
  typename QueryCorner<N>::Point leaves, enters;
  N area;

  [[gnu::always_inline]] explicit CornerCornerOverlaps(const CornerLens<N>& lens)
      : leaves(lens.leaves), enters(lens.enters) {
    area = 0.5 * ((leaves.x - enters.x) * (lens.q.at.y - lens.p.at.y) -
                  (leaves.y - enters.y) * (lens.q.at.x - lens.p.at.x));
  }
  [[nodiscard, gnu::always_inline]] bool has_digits(std::size_t) const { return true; }
  [[nodiscard, gnu::always_inline]] CornerCornerOverlap overlap(std::size_t l) const {
    return {.leaves_a = {lane(leaves.x, l), lane(leaves.y, l)},
            .enters_a = {lane(enters.x, l), lane(enters.y, l)},
            .area = lane(area, l)};
  }
};

// Calls `found` with the overlap of each query that has one; as many queries as N has lanes.
template <class N, template <class> class Overlaps, class Found>
[[gnu::always_inline]] inline void find_corner_corner_overlaps(const CornerCornerQuery* queries,
                                                               Found&& found) {
  const CornerLens<N> lens(queries);
  const Overlaps<N> overlaps(lens);
  const auto report = [&](std::size_t l) __attribute__((always_inline)) {
    const CornerCornerQuery& query = queries[l];
    if (!(lane(lens.crossing, l) > 0) || !overlaps.has_digits(l)) return;
    // The triangle of the corner holds most of what lies near it.
    if (!(lane(lens.inside_b, l) > 0) &&
        !inside_beyond_corner(query.b, query.j, query.a[query.i], query.margin))
      return;
    if (!(lane(lens.inside_a, l) > 0) &&
        !inside_beyond_corner(query.a, query.i, query.b[query.j], query.margin))
      return;
    found(l, overlaps.overlap(l));
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

/// The lenses at corners of two convex rings, where a lens is all that the two have in common. Face
/// upon face, one over the end of the other, is of this kind. Nothing where that is not so by a
/// clear margin.
/// @tparam lanes number of overlaps evaluated at once (SIMD); results do not depend on it
/// @tparam Overlaps what is evaluated, for a number type: from an internal::CornerLens; nothing is
/// found where `has_digits` says that round-off has spoiled it
/// @param found called with the index of every query that has a lens, and the overlap
template <std::size_t lanes = native_lanes,
          template <class> class Overlaps = internal::CornerCornerOverlaps, std::size_t count,
          class Found>
[[gnu::flatten]] void
find_corner_corner_overlaps(const std::array<CornerCornerQuery, count>& queries, Found&& found) {
  static_assert(count % lanes == 0);
  for (std::size_t first = 0; first < count; first += lanes)
    internal::find_corner_corner_overlaps<Simd<double, lanes>, Overlaps>(
        queries.data() + first, [&](std::size_t l, const auto& overlap)
                                    __attribute__((always_inline)) { found(first + l, overlap); });
}

/// The lens at one pair of corners, or nothing.
template <template <class> class Overlaps = internal::CornerCornerOverlaps>
[[nodiscard, gnu::flatten]] auto corner_corner_overlap(const CornerCornerQuery& query) {
  std::optional<decltype(std::declval<const Overlaps<double>&>().overlap(0))> found;
  internal::find_corner_corner_overlaps<double, Overlaps>(
      &query, [&](std::size_t, const auto& overlap) { found = overlap; });
  return found;
}

}  // namespace riprap
