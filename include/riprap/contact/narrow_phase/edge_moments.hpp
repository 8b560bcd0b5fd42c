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
/// along that edge's normal. In the frame of the edge, from the low end of the chord: along the
/// edge, and into the body with the edge as far as the centroid.
template <class N>
struct EdgeDepth {
  N along{}, inwards{}, depth{}, gradient{}, area{};
};

/// One corner: a triangle.
template <class N>
[[nodiscard, gnu::always_inline]] inline EdgeDepth<N> corner_depth(const EdgeCap<N>& cap,
                                                                   const N& chord) {
  const N tip = cap.in.deep * cap.scale;
  const N p = (cap.in.inside_along - cap.out.along) * cap.scale;
  const N q = chord - p;
  const N reciprocal = 1 / (chord * chord + 2 * tip * tip + p * p + q * q);
  EdgeDepth<N> d;
  d.gradient = chord * square_root(N(2 * reciprocal));
  d.depth = d.gradient * tip;
  d.along = p + (q - p) * (tip * tip - p * q) * reciprocal;
  d.inwards = tip * (1.0 / 3);
  d.area = 0.5 * chord * tip;
  return d;
}

/// Two corners: the quadrangle of the chord and both.
template <class N>
[[nodiscard, gnu::always_inline]] inline EdgeDepth<N> face_depth(const EdgeCap<N>& cap,
                                                                 const N& chord) {
  const auto place = [&](const EdgeCrossing<N>& crossing) __attribute__((always_inline)) {
    return FramePoint<N>{(crossing.inside_along - cap.out.along) * cap.scale,
                         crossing.deep * cap.scale};
  };
  const QuadrangleMoments<N> m({chord, N{}}, place(cap.in), place(cap.out));
  const auto density = [&](const N& along) __attribute__((always_inline)) {
    return m.density({along - m.centroid.u, -m.centroid.v});
  };
  const N low = density(N{});
  const N high = density(chord);
  const N sum = low + 4 * density(0.5 * chord) + high;
  EdgeDepth<N> d;
  d.depth = m.depth;
  d.gradient = m.unit * chord * sum * (1.0 / 6) / m.depth;
  d.along = 0.5 * chord * (1 + (high - low) / sum);
  d.inwards = m.centroid.v;
  d.area = m.area;
  return d;
}

/// Of as many pairs as N has lanes.
template <class N>
struct EdgeMoments {
  const EdgeCap<N>& cap;
  N chord = cap.width * cap.scale;
  EdgeDepth<N> corner = corner_depth(cap, chord);
  EdgeDepth<N> face{};

  [[gnu::always_inline]] explicit EdgeMoments(const EdgeCap<N>& edge_cap) : cap(edge_cap) {
    if (cap.has_faces) face = face_depth(cap, chord);
  }

  /// The contact, with the normal out of the edge.
  [[nodiscard, gnu::always_inline]] ContactGeometry overlap(std::size_t l, bool one_vertex) const {
    const EdgeDepth<N>& d = one_vertex ? corner : face;
    const double scale = lane(cap.scale, l);
    const double x = lane(cap.edge.x, l) * scale;
    const double y = lane(cap.edge.y, l) * scale;
    const double along = lane(cap.out.along, l) * scale + lane(d.along, l);
    const double inwards = lane(d.inwards, l);
    return {.normal = {y, -x},
            .point = {lane(cap.start.x, l) + along * x - inwards * y,
                      lane(cap.start.y, l) + along * y + inwards * x},
            .depth = lane(d.depth, l),
            .area = lane(d.area, l),
            .chord = lane(chord, l),
            .depth_gradient = lane(d.gradient, l)};
  }
};

}  // namespace riprap::internal
