// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The largest circle in a polygon, the smallest one around it, and the one nearest to given
/// points. Optional: not part of riprap.hpp.

#include <span>

#include <riprap/core/linkage.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/geometry/outline.hpp>

namespace riprap {

struct Circle {
  Vec2 centre{0, 0};  ///< [m]
  double radius = 0;  ///< [m]
};

/// The largest circle inside. The radius is exact to 1e-11 of the diameter, the centre to some 1e-7
/// of it; where more than one centre will do, as in a rectangle, it is in their middle.
[[nodiscard]] Circle inscribed_circle(const ConvexPolygon& polygon);

/// A circle inside whose radius is the largest to a share `tolerance`, from below; concave
/// outlines, too. Squares are quartered, those first in which the largest circle may be centred,
/// until none can have a larger one. Where many centres will do, as in a rectangle, the number of
/// squares is of the order of 1 / tolerance, each at the cost of all edges. Throws InvalidInput for
/// a tolerance outside [1e-6, 1).
[[nodiscard]] Circle inscribed_circle(const Outline& outline, double tolerance = 1e-4);

/// The smallest circle around all vertices, exact to round-off (E. Welzl, LNCS 555, 1991).
[[nodiscard]] Circle circumscribed_circle(Ring ring);

/// The circle with the least sum of squares of |x - centre|^2 - radius^2 over three or more points
/// x that are not on a line (I. Kasa, IEEE Trans. Instrum. Meas. 25, 1976): exact for points on a
/// circle, a little too small for points scattered about a short arc.
[[nodiscard]] Circle least_squares_circle(std::span<const Vec2> points);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/geometry/circles.ipp>
#endif
