// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Depth of OverlapMoments for a corner of each body in the other, in closed form.

#include <cstddef>

#include <riprap/contact/narrow_phase/quadrangle_moments.hpp>
#include <riprap/contact/pair/contact_geometry.hpp>
#include <riprap/core/simd.hpp>
#include <riprap/geometry/corner_corner_overlap.hpp>

namespace riprap::internal {

/// Of as many pairs as N has lanes. In a frame along the chord, from where the boundary enters a:
/// a's corner, the other crossing, b's corner.
template <class N>
struct CornerMoments {
  N normal_x, normal_y, point_x, point_y, depth, gradient, area, chord, det;

  [[gnu::always_inline]] explicit CornerMoments(const CornerLens<N>& lens) {
    const N dx = lens.leaves.x - lens.enters.x;
    const N dy = lens.leaves.y - lens.enters.y;
    chord = square_root(N(dx * dx + dy * dy));
    const N scale = 1 / chord;
    const N ux = dx * scale;
    const N uy = dy * scale;
    const auto place = [&](const auto& corner) __attribute__((always_inline)) {
      const N x = corner.x - lens.enters.x;
      const N y = corner.y - lens.enters.y;
      return FramePoint<N>{x * ux + y * uy, y * ux - x * uy};
    };
    const FramePoint<N> p = place(lens.p.at);
    const QuadrangleMoments<N> m(p, {chord, N{}}, place(lens.q.at));
    area = m.area;
    det = m.det;
    depth = m.depth;

    // Force and moment from a's two edges.
    const FramePoint<N> enter{-m.centroid.u, -m.centroid.v};
    const FramePoint<N> corner{p.u + enter.u, p.v + enter.v};
    const FramePoint<N> leave{chord + enter.u, enter.v};
    const FramePoint<N> on_first{0.5 * (enter.u + corner.u), 0.5 * (enter.v + corner.v)};
    const FramePoint<N> on_second{0.5 * (corner.u + leave.u), 0.5 * (corner.v + leave.v)};
    const N at_enter = m.density(enter);
    const N at_first = 4 * m.density(on_first);
    const N at_corner = m.density(corner);
    const N at_second = 4 * m.density(on_second);
    const N at_leave = m.density(leave);
    const N first = at_enter + at_first + at_corner;
    const N second = at_corner + at_second + at_leave;
    const N edge_u = chord - p.u;  // of the second edge; its v is -p.v
    const N force_u = (first - second) * p.v;
    const N force_v = -(first * p.u + second * edge_u);
    const auto dot =
        [](const FramePoint<N>& r, const N& u, const N& v) __attribute__((always_inline)) {
      return r.u * u + r.v * v;
    };
    const N moment =
        -(at_enter * dot(enter, p.u, p.v) + at_first * dot(on_first, p.u, p.v) +
          at_corner * dot(corner, chord, N{}) + at_second * dot(on_second, edge_u, -p.v) +
          at_leave * dot(leave, edge_u, -p.v));

    const N length = square_root(N(force_u * force_u + force_v * force_v));
    const N inverse = 1 / length;
    const N n_u = force_u * inverse;
    const N n_v = force_v * inverse;
    const N arm = moment * inverse;
    gradient = m.unit * length * (1.0 / 6) / depth;
    normal_x = n_u * ux - n_v * uy;
    normal_y = n_u * uy + n_v * ux;
    const N at_u = m.centroid.u + arm * n_v;
    const N at_v = m.centroid.v - arm * n_u;
    point_x = lens.enters.x + at_u * ux - at_v * uy;
    point_y = lens.enters.y + at_u * uy + at_v * ux;
  }

  /// The chord of triangles may be far longer than what conditions are measured by.
  [[nodiscard, gnu::always_inline]] bool has_digits(std::size_t l) const {
    return lane(det, l) > 0 && lane(gradient, l) < 1e300;
  }
  [[nodiscard, gnu::always_inline]] ContactGeometry overlap(std::size_t l) const {
    return {.normal = {lane(normal_x, l), lane(normal_y, l)},
            .point = {lane(point_x, l), lane(point_y, l)},
            .depth = lane(depth, l),
            .area = lane(area, l),
            .chord = lane(chord, l),
            .depth_gradient = lane(gradient, l)};
  }
};

}  // namespace riprap::internal
