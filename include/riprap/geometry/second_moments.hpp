// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Second moments of area of a ring of vertices.

#include <cstddef>

#include <riprap/core/vec2.hpp>

namespace riprap {

/// Integrals over an area [m^4], x and y from a point; xx + yy is the polar moment.
struct SecondMoments {
  double xx = 0;  ///< of x^2
  double yy = 0;  ///< of y^2
  double xy = 0;  ///< of x y
};

/// Of a simple counter-clockwise ring, about `origin`: the sum over the triangles from there to its
/// edges, exact.
[[nodiscard]] inline SecondMoments second_moments(Ring ring, const Vec2& origin) {
  SecondMoments m;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2 p = ring[k] - origin;
    const Vec2 q = ring[k + 1 == ring.size() ? 0 : k + 1] - origin;
    const double t = cross(p, q) / 12;
    m.xx += t * (p.x() * p.x() + p.x() * q.x() + q.x() * q.x());
    m.yy += t * (p.y() * p.y() + p.y() * q.y() + q.y() * q.y());
    m.xy += t * (p.x() * p.y() + 0.5 * (p.x() * q.y() + q.x() * p.y()) + q.x() * q.y());
  }
  return m;
}

}  // namespace riprap
