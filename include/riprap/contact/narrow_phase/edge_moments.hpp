// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Moments of an overlap of one or two corners with an edge, and the depth they give: closed form.

#include <cstddef>

#include <riprap/contact/contact_geometry.hpp>
#include <riprap/core/simd.hpp>
#include <riprap/geometry/corner_edge_overlap.hpp>

namespace riprap::internal {

/// The depth of OverlapMoments, for as many pairs as N has lanes. The overlap is the quadrangle of
/// the chord, on the edge, and the vertices beyond it, of which two may be the same. As it rests on
/// a single edge of one body, the force acts along that edge's normal.
template <class N>
struct EdgeMoments {
  N normal_x, normal_y, point_x, point_y, depth, gradient, area, chord;

  [[gnu::always_inline]] explicit EdgeMoments(const EdgeCap<N>& cap) {
    const N& scale = cap.scale;
    chord = cap.width * scale;
    // Relative to the low end of the chord: p after the boundary goes in, q before it comes out.
    const N p_along = (cap.in.inside_along - cap.out.along) * scale;
    const N q_along = (cap.out.inside_along - cap.out.along) * scale;
    const N p_deep = cap.in.deep * scale;
    const N q_deep = cap.out.deep * scale;
    // Triangles of the chord and p, and of its low end, p and q.
    const N first = 0.5 * chord * p_deep;
    const N second = 0.5 * (p_along * q_deep - q_along * p_deep);
    area = first + second;
    const N share = second / area;
    const N centroid_along = (chord + p_along + share * (q_along - chord)) * (1.0 / 3);
    const N centroid_deep = (p_deep + share * q_deep) * (1.0 / 3);
    // Covariances: of each triangle, and of their centroids.
    const N apart_along = q_along - chord;
    const N between = first * share * (1.0 / 9);
    const N f = first * (1.0 / 18);
    const N s = second * (1.0 / 18);
    const N uu = f * (chord * chord + p_along * p_along - chord * p_along) +
                 s * (p_along * p_along + q_along * q_along - p_along * q_along) +
                 between * apart_along * apart_along;
    const N vv = f * p_deep * p_deep + s * (p_deep * p_deep + q_deep * q_deep - p_deep * q_deep) +
                 between * q_deep * q_deep;
    const N uv =
        f * (p_along * p_deep - 0.5 * chord * p_deep) +
        s * (p_along * p_deep + q_along * q_deep - 0.5 * (p_along * q_deep + q_along * p_deep)) +
        between * apart_along * q_deep;
    const N det = uu * vv - uv * uv;
    const N trace = uu + vv;
    const N unit = 12 / (area * trace);
    // Density of the force at both ends and in the middle of the chord.
    const N of_trace = det / trace;
    const N constant =
        uu * centroid_deep * centroid_deep - of_trace * centroid_deep * centroid_deep - det / area;
    const auto density = [&](const N& along) __attribute__((always_inline)) {
      const N r = along - centroid_along;
      return r * ((vv - of_trace) * r + 2 * uv * centroid_deep) + constant;
    };
    const N low = density(N{});
    const N middle = density(0.5 * chord);
    const N high = density(chord);
    const N sum = low + 4 * middle + high;
    depth = square_root(2 * unit * det);
    gradient = unit * chord * sum * (1.0 / 6) / depth;
    // Along the normal the force acts as deep as the centroid lies.
    const N along = (cap.out.along * scale + 0.5 * chord * (1 + (high - low) / sum)) * scale;
    const N deep = centroid_deep * scale;
    normal_x = cap.edge.y * scale;
    normal_y = -cap.edge.x * scale;
    point_x = cap.start.x + along * cap.edge.x - deep * cap.edge.y;
    point_y = cap.start.y + along * cap.edge.y + deep * cap.edge.x;
  }

  /// The contact, with the normal out of the edge.
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
