// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Depth of OverlapMoments for one or two corners in an edge, in closed form.

#include <cstddef>

#include <riprap/contact/narrow_phase/quadrangle_moments.hpp>
#include <riprap/contact/pair/contact_geometry.hpp>
#include <riprap/core/simd.hpp>
#include <riprap/geometry/corner_edge_overlap.hpp>

namespace riprap::internal {

/// Depth and line of action. The overlap rests on a single edge of one body, so that the force acts
/// along that edge's normal. In the frame of the edge, from its start: along the edge, and into the
/// body with the edge as far as the centroid. As in EdgeCap lengths are times that of the edge, and
/// the area times its square.
template <class N>
struct EdgeDepth {
  N along, inwards, twice_area;
  N slope;     // depth / (2 A)
  N gradient;  // over the slope
};

/// One corner: a triangle.
template <class N>
[[nodiscard, gnu::always_inline]] inline EdgeDepth<N> corner_depth(const EdgeCap<N>& cap) {
  const N& tip = cap.in.deep;
  const N p = -cap.out.further;
  const N q = cap.in.further;
  // 1 / sqrt(sum) as sqrt(sum) (1 / sum): the root and the division do not wait for each other.
  const N sum = (p * p + q * q) + (p * q + tip * tip);
  const N reciprocal = 1 / sum;
  return {.along = cap.in.inside_along + 0.5 * (q - p) * (tip * tip - p * q) * reciprocal,
          .inwards = tip * (1.0 / 3),
          .twice_area = cap.width * tip,
          .slope = square_root(sum) * reciprocal,
          .gradient = cap.width};
}

/// Two corners: the quadrangle of the chord and both.
template <class N>
[[nodiscard, gnu::always_inline]] inline EdgeDepth<N> face_depth(const EdgeCap<N>& cap) {
  const N& chord = cap.width;
  const PlaneVector<N> d{cap.in.inside_along - cap.out.along, cap.in.deep};
  const PlaneVector<N> e{cap.out.inside_along - cap.in.along, cap.out.deep};
  const QuadrangleMoments<N> m(d, e, d.cross(e), chord * e.y, chord * d.y);
  const N a1 = 1 + m.a;
  const N b1 = 1 + m.b;
  const N on_d = 0.5 - m.a * (1.0 / 6);
  const N on_e = m.b * (1.0 / 3);
  // Mean density of the force on the chord, and a twelfth of its rise along it, over W / A.
  const N mean = 1 + a1 * b1 * m.skew;
  const N rise = (m.a - m.b) * a1 * b1 * m.per_shape -
                 6 * chord * (chord - 2 * (on_d * d.x + on_e * e.x)) * m.per_spread;
  return {.along = cap.out.along + chord * (0.5 + rise / mean),
          .inwards = on_d * d.y + on_e * e.y,
          .twice_area = m.twice_area,
          .slope = m.slope,
          .gradient = chord * mean};
}

/// Lane by lane `face` where two corners lie beyond the edge, else `corner`.
template <class N>
[[nodiscard, gnu::always_inline]] inline EdgeDepth<N>
where_face(const EdgeCap<N>& cap, const EdgeDepth<N>& face, const EdgeDepth<N>& corner) {
  const auto one = (cap.in.inside_along == cap.out.inside_along) & (cap.in.deep == cap.out.deep);
  return {one ? corner.along : face.along, one ? corner.inwards : face.inwards,
          one ? corner.twice_area : face.twice_area, one ? corner.slope : face.slope,
          one ? corner.gradient : face.gradient};
}

/// Of as many pairs as N has lanes; the normal is out of the edge, or into it where the depth falls
/// as the bodies come closer.
template <class N>
struct EdgeMoments {
  N normal_x, normal_y, point_x, point_y, depth, gradient, area, chord;

  [[gnu::always_inline]] explicit EdgeMoments(const EdgeCap<N>& cap) {
    EdgeDepth<N> r = corner_depth(cap);
    normal_x = cap.edge.y * cap.scale;
    normal_y = -cap.edge.x * cap.scale;
    if (cap.has_faces) {
      r = where_face(cap, face_depth(cap), r);
      // Of a body that is wider inside than at the edge the depth may fall as it comes closer.
      const auto drawn = r.gradient < 0;
      normal_x = drawn ? -normal_x : normal_x;
      normal_y = drawn ? -normal_y : normal_y;
      r.gradient = drawn ? -r.gradient : r.gradient;
    }
    const N per_squared = cap.scale * cap.scale;
    const N along = r.along * per_squared;
    const N inwards = r.inwards * per_squared;
    point_x = cap.start.x + along * cap.edge.x - inwards * cap.edge.y;
    point_y = cap.start.y + along * cap.edge.y + inwards * cap.edge.x;
    depth = r.slope * (r.twice_area * cap.scale);
    gradient = r.slope * r.gradient;
    area = 0.5 * r.twice_area * per_squared;
    chord = cap.width * cap.scale;
  }

  [[nodiscard, gnu::always_inline]] ContactGeometry overlap(std::size_t l, bool) const {
    return {.normal = {lane(normal_x, l), lane(normal_y, l)},
            .point = {lane(point_x, l), lane(point_y, l)},
            .depth = lane(depth, l),
            .area = lane(area, l),
            .chord = lane(chord, l),
            .depth_gradient = lane(gradient, l)};
  }
};

}  // namespace riprap::internal
