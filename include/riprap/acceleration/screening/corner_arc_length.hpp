// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Arc length by which the boundary point of a position near a corner has moved.

#include <algorithm>
#include <cmath>

#include <riprap/stress/boundary_locator.hpp>

namespace riprap {

/// Contact points near the corner of a particle, the most common ones, often change edges. The
/// nearest edge is the one onto which the position has the longer projection from the corner.
/// Single precision.
struct CornerArcLength {
  float valid_radius = -1;  ///< distance the position may move with these edges nearest [m]
  float x = 0, y = 0;
  float before_x = 0, before_y = 0;
  float after_x = 0, after_y = 0;
  float from_corner = 0;
  float round_off = 0;

  CornerArcLength() = default;
  /// @param safe_radius `place.corner_radius` less the round-off of positions [m]
  /// @param lost round-off of differences of positions [m]
  CornerArcLength(const LocatedPoint& place, double safe_radius, double lost)
      : valid_radius(static_cast<float>(safe_radius)), x(static_cast<float>(place.corner.x())),
        y(static_cast<float>(place.corner.y())), before_x(static_cast<float>(place.before.x())),
        before_y(static_cast<float>(place.before.y())),
        after_x(static_cast<float>(place.after.x())), after_y(static_cast<float>(place.after.y())),
        from_corner(static_cast<float>(place.from_corner)), round_off(static_cast<float>(lost)) {}

  /// Lengths of the projections of a position onto the two edges, from the corner, and the arc
  /// length by which the boundary point has moved if it lies on one or on the other [m].
  struct Projections {
    float before, after;
    float arc_before, arc_after;

    [[nodiscard]] float longer_arc() const { return std::max(arc_before, arc_after); }
  };
  [[nodiscard]] Projections projections(float place_x, float place_y) const {
    const float dx = place_x - x;
    const float dy = place_y - y;
    const float before = std::max(0.0f, dx * before_x + dy * before_y);
    const float after = std::max(0.0f, dx * after_x + dy * after_y);
    return {before, after, std::abs(before + from_corner), std::abs(after - from_corner)};
  }

  /// Arc length to the point on the nearer edge; the larger one where round-off leaves that open.
  [[nodiscard]] float arc_length(const Projections& at) const {
    if (at.before > at.after + round_off) return at.arc_before;
    if (at.after > at.before + round_off) return at.arc_after;
    return at.longer_arc();
  }
  /// While the position moves by less than this [m], its boundary point stays on its edge: neither
  /// projection changes by more than the position.
  [[nodiscard]] float edge_radius(const Projections& at) const {
    return 0.5f * (std::abs(at.before - at.after) - round_off);
  }
};

}  // namespace riprap
