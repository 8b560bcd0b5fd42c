// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// How far a place near a corner has gone along the boundary.

#include <algorithm>
#include <cmath>

#include <riprap/stress/outline.hpp>

namespace riprap {

/// Places near the corner of a particle, the most common ones, change edges often. What their
/// boundary points then move by follows from the edges: that of the longer foot is the nearer one.
/// Single precision.
struct CornerWay {
  float hold = -1;  ///< how far the place may move for all this to be so [m]
  float x = 0, y = 0;
  float before_x = 0, before_y = 0;
  float after_x = 0, after_y = 0;
  float from_corner = 0;
  float round_off = 0;

  CornerWay() = default;
  /// @param safe_hold below `place.corner_hold` by what may be lost in rounding [m]
  /// @param lost in rounding of differences of places [m]
  CornerWay(const OutlinePoint& place, double safe_hold, double lost)
      : hold(static_cast<float>(safe_hold)), x(static_cast<float>(place.corner.x())),
        y(static_cast<float>(place.corner.y())), before_x(static_cast<float>(place.before.x())),
        before_y(static_cast<float>(place.before.y())),
        after_x(static_cast<float>(place.after.x())), after_y(static_cast<float>(place.after.y())),
        from_corner(static_cast<float>(place.from_corner)), round_off(static_cast<float>(lost)) {}

  /// Projections of a place onto the edges, from the corner, and the ways that the boundary point
  /// has gone if it is on one or on the other [m].
  struct Feet {
    float before, after;
    float way_before, way_after;

    [[nodiscard]] float longer_way() const { return std::max(way_before, way_after); }
  };
  [[nodiscard]] Feet feet(float place_x, float place_y) const {
    const float dx = place_x - x;
    const float dy = place_y - y;
    const float before = std::max(0.0f, dx * before_x + dy * before_y);
    const float after = std::max(0.0f, dx * after_x + dy * after_y);
    return {before, after, std::abs(before + from_corner), std::abs(after - from_corner)};
  }

  /// That on the nearer edge; the longer one where round-off may hide which it is.
  [[nodiscard]] float way(const Feet& at) const {
    if (at.before > at.after + round_off) return at.way_before;
    if (at.after > at.before + round_off) return at.way_after;
    return at.longer_way();
  }
  /// While the place moves by less than this [m], its boundary point stays on the edge that it is
  /// on, for neither foot moves by more than the place.
  [[nodiscard]] float edge_hold(const Feet& at) const {
    return 0.5f * (std::abs(at.before - at.after) - round_off);
  }
};

}  // namespace riprap
