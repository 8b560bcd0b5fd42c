// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The largest circle in a convex polygon and the smallest one around it. Optional: not part of
/// riprap.hpp.

#include <riprap/core/linkage.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/geometry/convex_polygon.hpp>

namespace riprap {

struct Circle {
  Vec2 centre{0, 0};  ///< [m]
  double radius = 0;  ///< [m]
};

/// The largest circle inside. The radius is exact to 1e-11 of the diameter, the centre to some 1e-7
/// of it; where more than one centre will do, as in a rectangle, it is in their middle.
[[nodiscard]] Circle inscribed_circle(const ConvexPolygon& polygon);

/// The smallest circle around all vertices, exact to round-off (E. Welzl, LNCS 555, 1991).
[[nodiscard]] Circle circumscribed_circle(Ring ring);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/geometry/circles.ipp>
#endif
