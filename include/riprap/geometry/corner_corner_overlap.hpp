// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What two convex rings have in common where a corner of each lies in the other.

#include <cstddef>
#include <optional>

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

namespace internal {

/// Does v, between the two edges at vertex `j` of a convex ring, lie inside all others as well, by
/// a clear margin [m]?
[[nodiscard]] inline bool inside_beyond_corner(Ring ring, std::size_t j, const Vec2& v,
                                               double margin) {
  const std::size_t n = ring.size();
  const std::size_t before = previous_vertex(j, n);
  // The triangle of the corner holds most of what lies near it.
  if (LineSide(ring[next_vertex(j, n)], ring[before]).lies_left_by(v, 1.5 * margin)) return true;
  for (std::size_t k = 0; k < n; ++k)
    if (k != j && k != before &&
        !LineSide(ring[k], ring[next_vertex(k, n)]).lies_left_by(v, margin))
      return false;
  return true;
}

}  // namespace internal

/// The lens at vertex `i` of `a` and vertex `j` of `b`, if it is all that the two convex rings have
/// in common. Face upon face, one over the end of the other, is of this kind. Nothing where that is
/// not so by a clear `margin` [m].
[[nodiscard]] inline std::optional<CornerCornerOverlap>
corner_corner_overlap(Ring a, std::size_t i, Ring b, std::size_t j, double margin) {
  const Vec2& p = a[i];
  const Vec2& p_next = a[next_vertex(i, a.size())];
  const Vec2& p_before = a[previous_vertex(i, a.size())];
  const Vec2& q = b[j];
  const Vec2& q_next = b[next_vertex(j, b.size())];
  const Vec2& q_before = b[previous_vertex(j, b.size())];
  const LineSide out_of_p(p, p_next);
  const LineSide into_p(p_before, p);
  const LineSide out_of_q(q, q_next);
  const LineSide into_q(q_before, q);
  // The edge out of p crosses the edge into q, and vice versa.
  const double p_deep = into_q(p);
  const double p_out = into_q(p_next);
  const double q_deep = into_p(q);
  const double q_out = into_p(q_next);
  const double q_there = out_of_p(q);
  const double q_here = out_of_p(q_before);
  const double p_there = out_of_q(p);
  const double p_here = out_of_q(p_before);
  const double to_p = margin * into_p.length_bound();
  const double to_q = margin * into_q.length_bound();
  const double from_p = margin * out_of_p.length_bound();
  const double from_q = margin * out_of_q.length_bound();
  const bool crossing = (p_deep > to_q) & (p_out < -to_q) & (q_deep > to_p) & (q_out < -to_p) &
                        (q_there > from_p) & (q_here < -from_p) & (p_there > from_q) &
                        (p_here < -from_q);
  if (!crossing || !internal::inside_beyond_corner(b, j, p, margin) ||
      !internal::inside_beyond_corner(a, i, q, margin))
    return std::nullopt;
  CornerCornerOverlap lens;
  lens.leaves_a = p + (p_deep / (p_deep - p_out)) * (p_next - p);
  lens.enters_a = q + (q_deep / (q_deep - q_out)) * (q_next - q);
  lens.area = 0.5 * cross(lens.leaves_a - lens.enters_a, q - p);
  return lens;
}

}  // namespace riprap
