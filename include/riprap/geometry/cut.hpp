// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A convex ring cut by a straight line into two.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <riprap/core/linkage.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/geometry/polygon_properties.hpp>

namespace riprap {

/// The straight line through `point` along the unit vector `direction`.
struct Line {
  Vec2 point{0, 0};
  Vec2 direction{1, 0};

  /// Distance of x from the line [m], positive on the left of `direction`.
  [[nodiscard]] double left_distance(const Vec2& x) const { return cross(direction, x - point); }

  static void for_each_field(auto& self, auto&& visit) {
    visit("point", self.point);
    visit("direction", self.direction);
  }
};

/// The two parts of a ring, on the left and on the right of the cutting line.
struct CutRings {
  std::vector<Vec2> left;
  std::vector<Vec2> right;
};

namespace internal {

/// The parts of a convex ring as `cut` has them, whatever round-off does to their areas.
[[nodiscard]] std::optional<CutRings> divide(Ring ring, const Line& line, double snap);

}  // namespace internal

/// Cuts a convex ring. Of the vertices within `relative_snap` diameters of either end of the cut
/// the nearest one becomes that end, so that no edge comes out too short to matter. The pieces
/// share both ends of the cut, and each vertex of the ring that is no end belongs to one of them:
/// they do not overlap, and their areas add up to that of the ring to a share of 1e-12. Nothing if
/// the line leaves one side empty, or if round-off keeps the areas from adding up (needles of less
/// than a millionth of their length).
[[nodiscard]] std::optional<CutRings> cut(Ring ring, const Line& line, double relative_snap = 1e-6);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/geometry/cut.ipp>
#endif
