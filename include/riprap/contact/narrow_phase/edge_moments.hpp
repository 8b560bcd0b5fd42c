// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Moments of an overlap of one or two corners with an edge, and the depth they give: closed form.

#include <cstddef>

#include <riprap/contact/pair/contact_geometry.hpp>
#include <riprap/core/simd.hpp>
#include <riprap/geometry/corner_edge_overlap.hpp>

namespace riprap::internal {

// As it rests on a single edge of one body, the force acts along that edge's normal. In the frame
// of the edge, from the low end of the chord: along the edge, and as deep as the centroid lies.

/// One corner: a triangle.
template <class N>
struct TriangleMoments {
  N along, deep, depth, gradient, area;

  [[gnu::always_inline]] TriangleMoments(const EdgeCap<N>& cap, const N& chord) {
    const N tip = cap.in.deep * cap.scale;
    const N p = (cap.in.inside_along - cap.out.along) * cap.scale;
    const N q = chord - p;
    const N reciprocal = 1 / (chord * chord + 2 * tip * tip + p * p + q * q);
    gradient = chord * square_root(N(2 * reciprocal));
    depth = gradient * tip;
    along = p + (q - p) * (tip * tip - p * q) * reciprocal;
    deep = tip * (1.0 / 3);
    area = 0.5 * chord * tip;
  }
};

/// Two corners: the quadrangle of the chord, p after the boundary goes in and q before it comes
/// out.
template <class N>
struct QuadrangleMoments {
  N along{}, deep{}, depth{}, gradient{}, area{};

  QuadrangleMoments() = default;
  [[gnu::always_inline]] QuadrangleMoments(const EdgeCap<N>& cap, const N& chord) {
    const N& scale = cap.scale;
    const N p_along = (cap.in.inside_along - cap.out.along) * scale;
    const N q_along = (cap.out.inside_along - cap.out.along) * scale;
    const N p_deep = cap.in.deep * scale;
    const N q_deep = cap.out.deep * scale;
    // Triangles of the chord and p, and of its low end, p and q.
    const N first = 0.5 * chord * p_deep;
    const N second = 0.5 * (p_along * q_deep - q_along * p_deep);
    area = first + second;
    const N share = second / area;
    const N centroid = (chord + p_along + share * (q_along - chord)) * (1.0 / 3);
    deep = (p_deep + share * q_deep) * (1.0 / 3);
    // Second moments: of each triangle about its centroid, and of their centroids.
    const N apart = q_along - chord;
    const N between = first * share * (1.0 / 9);
    const N f = first * (1.0 / 18);
    const N s = second * (1.0 / 18);
    const N uu = f * (chord * chord + p_along * p_along - chord * p_along) +
                 s * (p_along * p_along + q_along * q_along - p_along * q_along) +
                 between * apart * apart;
    const N vv = f * p_deep * p_deep + s * (p_deep * p_deep + q_deep * q_deep - p_deep * q_deep) +
                 between * q_deep * q_deep;
    const N uv =
        f * (p_along * p_deep - 0.5 * chord * p_deep) +
        s * (p_along * p_deep + q_along * q_deep - 0.5 * (p_along * q_deep + q_along * p_deep)) +
        between * apart * q_deep;
    const N det = uu * vv - uv * uv;
    const N trace = uu + vv;
    const N unit = 12 / (area * trace);
    // Density of the force at both ends and in the middle of the chord.
    const N of_trace = det / trace;
    const N constant = (uu - of_trace) * deep * deep - det / area;
    const auto density = [&](const N& at) __attribute__((always_inline)) {
      const N r = at - centroid;
      return r * ((vv - of_trace) * r + 2 * uv * deep) + constant;
    };
    const N low = density(N{});
    const N high = density(chord);
    const N sum = low + 4 * density(0.5 * chord) + high;
    depth = square_root(N(2 * unit * det));
    gradient = unit * chord * sum * (1.0 / 6) / depth;
    along = 0.5 * chord * (1 + (high - low) / sum);
  }
};

/// Of as many pairs as N has lanes.
template <class N>
struct EdgeMoments {
  const EdgeCap<N>& cap;
  N chord = cap.width * cap.scale;
  TriangleMoments<N> triangle{cap, chord};
  QuadrangleMoments<N> quadrangle{};

  [[gnu::always_inline]] explicit EdgeMoments(const EdgeCap<N>& edge_cap) : cap(edge_cap) {
    if (cap.has_faces) quadrangle = QuadrangleMoments<N>(cap, chord);
  }

  /// The contact, with the normal out of the edge.
  [[nodiscard, gnu::always_inline]] ContactGeometry overlap(std::size_t l, bool one_vertex) const {
    return one_vertex ? contact(l, triangle) : contact(l, quadrangle);
  }

 private:
  template <class Moments>
  [[nodiscard, gnu::always_inline]] ContactGeometry contact(std::size_t l, const Moments& m) const {
    const double scale = lane(cap.scale, l);
    const double x = lane(cap.edge.x, l) * scale;
    const double y = lane(cap.edge.y, l) * scale;
    const double along = lane(cap.out.along, l) * scale + lane(m.along, l);
    const double deep = lane(m.deep, l);
    return {.normal = {y, -x},
            .point = {lane(cap.start.x, l) + along * x - deep * y,
                      lane(cap.start.y, l) + along * y + deep * x},
            .depth = lane(m.depth, l),
            .area = lane(m.area, l),
            .chord = lane(chord, l),
            .depth_gradient = lane(m.gradient, l)};
  }
};

}  // namespace riprap::internal
