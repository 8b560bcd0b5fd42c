// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Moments of the overlap of two corners, and the depth they give: closed form.

#include <cstddef>

#include <riprap/contact/pair/contact_geometry.hpp>
#include <riprap/core/simd.hpp>
#include <riprap/geometry/corner_corner_overlap.hpp>

namespace riprap::internal {

/// The quadrangle of a corner of a, p, one of b, q, and the crossings, for as many pairs as N has
/// lanes.
template <class N>
struct CornerMoments {
  N normal_x, normal_y, point_x, point_y, depth, gradient, area, chord;

  [[gnu::always_inline]] explicit CornerMoments(const CornerLens<N>& lens) {
    // Relative to where the boundary enters a: p, the other crossing, q.
    const N px = lens.p.at.x - lens.enters.x;
    const N py = lens.p.at.y - lens.enters.y;
    const N dx = lens.leaves.x - lens.enters.x;
    const N dy = lens.leaves.y - lens.enters.y;
    const N qx = lens.q.at.x - lens.enters.x;
    const N qy = lens.q.at.y - lens.enters.y;
    const N first = 0.5 * (px * dy - py * dx);
    const N second = 0.5 * (dx * qy - dy * qx);
    area = first + second;
    const N share = second / area;
    const N apart_x = qx - px;
    const N apart_y = qy - py;
    const N cx = (px + dx + share * apart_x) * (1.0 / 3);
    const N cy = (py + dy + share * apart_y) * (1.0 / 3);
    // Second moments: of each triangle about its centroid, and of their centroids.
    const N between = first * share * (1.0 / 9);
    const N f = first * (1.0 / 18);
    const N s = second * (1.0 / 18);
    const N xx = f * (px * px + dx * dx - px * dx) + s * (dx * dx + qx * qx - dx * qx) +
                 between * apart_x * apart_x;
    const N yy = f * (py * py + dy * dy - py * dy) + s * (dy * dy + qy * qy - dy * qy) +
                 between * apart_y * apart_y;
    const N xy = f * (px * py + dx * dy - 0.5 * (px * dy + dx * py)) +
                 s * (dx * dy + qx * qy - 0.5 * (dx * qy + qx * dy)) + between * apart_x * apart_y;
    const N det = xx * yy - xy * xy;
    const N trace = xx + yy;
    // Density of the force at both ends and in the middle of a's two edges.
    const N of_trace = det / trace;
    const N of_x = yy - of_trace;
    const N of_y = xx - of_trace;
    const N constant = det / area;
    const auto density = [&](const N& x, const N& y) __attribute__((always_inline)) {
      return of_x * x * x - 2 * xy * x * y + of_y * y * y - constant;
    };
    const N ex = px - cx;
    const N ey = py - cy;
    const N lx = dx - cx;
    const N ly = dy - cy;
    const N ux = 0.5 * px - cx;
    const N uy = 0.5 * py - cy;
    const N vx = 0.5 * (px + dx) - cx;
    const N vy = 0.5 * (py + dy) - cy;
    const N at_enter = density(-cx, -cy);
    const N at_p = density(ex, ey);
    const N at_leave = density(lx, ly);
    const N on_first = 4 * density(ux, uy);
    const N on_second = 4 * density(vx, vy);
    const N to_p = at_enter + on_first + at_p;
    const N from_p = at_p + on_second + at_leave;
    const N away_x = dx - px;
    const N away_y = dy - py;
    const N force_x = to_p * py + from_p * away_y;
    const N force_y = -(to_p * px + from_p * away_x);
    const N moment = at_enter * (cx * px + cy * py) - on_first * (ux * px + uy * py) -
                     at_p * (ex * dx + ey * dy) - on_second * (vx * away_x + vy * away_y) -
                     at_leave * (lx * away_x + ly * away_y);
    const N unit = 12 / (area * trace);
    const N squared = force_x * force_x + force_y * force_y;
    const N length = square_root(squared);
    const N scale = 1 / length;
    normal_x = force_x * scale;
    normal_y = force_y * scale;
    const N arm = moment * scale;
    point_x = lens.enters.x + cx + arm * normal_y;
    point_y = lens.enters.y + cy - arm * normal_x;
    depth = square_root(N(2 * unit * det));
    gradient = unit * length * (1.0 / 6) / depth;
    chord = square_root(N(dx * dx + dy * dy));
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
