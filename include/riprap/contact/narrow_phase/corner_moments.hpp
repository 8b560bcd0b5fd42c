// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Moments of the overlap of two corners, and the depth they give: closed form.

#include <cmath>

#include <riprap/contact/pair/contact_geometry.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/geometry/corner_corner_overlap.hpp>

namespace riprap::internal {

/// The contact of a quadrangle with a corner of a, `p`, and one of b, `q`. Plain numbers: classes
/// of Eigen for every expression would cost time to compile and to run.
[[nodiscard]] inline ContactGeometry corner_moments(const Vec2& p, const Vec2& q,
                                                    const CornerCornerOverlap& lens) {
  // Relative to where the boundary enters a: a's corner, the other end of the diagonal, b's corner.
  const double px = p.x() - lens.enters_a.x();
  const double py = p.y() - lens.enters_a.y();
  const double dx = lens.leaves_a.x() - lens.enters_a.x();
  const double dy = lens.leaves_a.y() - lens.enters_a.y();
  const double qx = q.x() - lens.enters_a.x();
  const double qy = q.y() - lens.enters_a.y();
  const double first = 0.5 * (px * dy - py * dx);
  const double second = 0.5 * (dx * qy - dy * qx);
  const double area = first + second;
  const double share = second / area;
  const double apart_x = qx - px;
  const double apart_y = qy - py;
  const double cx = (px + dx + share * apart_x) * (1.0 / 3);
  const double cy = (py + dy + share * apart_y) * (1.0 / 3);
  // Second moments: of each triangle about its centroid, and of their centroids.
  const double between = first * share * (1.0 / 9);
  const double f = first * (1.0 / 18);
  const double s = second * (1.0 / 18);
  const double xx = f * (px * px + dx * dx - px * dx) + s * (dx * dx + qx * qx - dx * qx) +
                    between * apart_x * apart_x;
  const double yy = f * (py * py + dy * dy - py * dy) + s * (dy * dy + qy * qy - dy * qy) +
                    between * apart_y * apart_y;
  const double xy = f * (px * py + dx * dy - 0.5 * (px * dy + dx * py)) +
                    s * (dx * dy + qx * qy - 0.5 * (dx * qy + qx * dy)) +
                    between * apart_x * apart_y;
  const double det = xx * yy - xy * xy;
  const double trace = xx + yy;
  // Density of the force at both ends and in the middle of a's two edges.
  const double of_trace = det / trace;
  const double constant = det / area;
  const auto density = [&](double x, double y) {
    return (yy - of_trace) * x * x - 2 * xy * x * y + (xx - of_trace) * y * y - constant;
  };
  const double ex = px - cx;
  const double ey = py - cy;
  const double lx = dx - cx;
  const double ly = dy - cy;
  const double at_enter = density(-cx, -cy);
  const double at_p = density(ex, ey);
  const double at_leave = density(lx, ly);
  const double ux = 0.5 * px - cx;
  const double uy = 0.5 * py - cy;
  const double vx = 0.5 * (px + dx) - cx;
  const double vy = 0.5 * (py + dy) - cy;
  const double on_first = 4 * density(ux, uy);
  const double on_second = 4 * density(vx, vy);
  const double to_p = at_enter + on_first + at_p;
  const double from_p = at_p + on_second + at_leave;
  const double away_x = dx - px;
  const double away_y = dy - py;
  const double force_x = to_p * py + from_p * away_y;
  const double force_y = -(to_p * px + from_p * away_x);
  const double moment = at_enter * (cx * px + cy * py) - on_first * (ux * px + uy * py) -
                        at_p * (ex * (px + away_x) + ey * (py + away_y)) -
                        on_second * (vx * away_x + vy * away_y) -
                        at_leave * (lx * away_x + ly * away_y);
  const double unit = 12 / (area * trace);
  const double depth = std::sqrt(2 * unit * det);
  const double length = std::sqrt(force_x * force_x + force_y * force_y);
  const double scale = 1 / length;
  const double nx = force_x * scale;
  const double ny = force_y * scale;
  const double arm = moment * scale;
  return {.normal = {nx, ny},
          .point = {lens.enters_a.x() + cx + arm * ny, lens.enters_a.y() + cy - arm * nx},
          .depth = depth,
          .area = area,
          .chord = std::sqrt(dx * dx + dy * dy),
          .depth_gradient = unit * length / (6 * depth)};
}

}  // namespace riprap::internal
