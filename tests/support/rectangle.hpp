// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Rectangles: the shape of most closed forms.

#include <riprap/geometry/convex_polygon.hpp>

namespace riprap::test {

/// A rectangle about `centre` [m], turned by `angle` [rad] about it.
[[nodiscard]] inline ConvexPolygon rectangle(const Vec2& centre, double width, double height,
                                             double angle = 0) {
  const ConvexPolygon upright{{-0.5 * width, -0.5 * height},
                              {0.5 * width, -0.5 * height},
                              {0.5 * width, 0.5 * height},
                              {-0.5 * width, 0.5 * height}};
  return upright.moved(Rotation::from_angle(angle), centre);
}

}  // namespace riprap::test
