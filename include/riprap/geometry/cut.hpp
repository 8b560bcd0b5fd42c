#pragma once
/// @file
/// A convex ring cut by a straight line into two.

#include <cmath>
#include <optional>
#include <vector>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/polygon_properties.hpp>

namespace riprap {

/// The straight line through `point` along the unit vector `direction`.
struct Line {
  Vec2 point{0, 0};
  Vec2 direction{1, 0};

  /// Distance of x from the line [m], positive on the left of `direction`.
  [[nodiscard]] double left_distance(const Vec2& x) const { return cross(direction, x - point); }
};

/// The two parts of a ring, on the left and on the right of the cutting line.
struct CutRings {
  std::vector<Vec2> left;
  std::vector<Vec2> right;
};

/// Cuts a convex ring. Vertices within `relative_snap` diameters of the line are taken to lie on
/// it, so that no edge comes out too short to matter; both parts use the same points, so that their
/// areas add up. Nothing if the line leaves one side empty.
[[nodiscard]] inline std::optional<CutRings> cut(Ring ring, const Line& line,
                                                 double relative_snap = 1e-6) {
  const double snap = relative_snap * diameter(ring);
  const auto side = [&](std::size_t i) {
    const double d = line.left_distance(ring[i]);
    return std::abs(d) <= snap ? 0.0 : d;
  };
  CutRings parts;
  bool any_left = false;
  bool any_right = false;
  double d = side(0);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t next = (i + 1) % ring.size();
    const double d_next = side(next);
    any_left |= d > 0;
    any_right |= d < 0;
    if (d >= 0) parts.left.push_back(ring[i]);
    if (d <= 0) parts.right.push_back(ring[i]);
    if (d * d_next < 0) {
      const Vec2 x = ring[i] + (d / (d - d_next)) * (ring[next] - ring[i]);
      parts.left.push_back(x);
      parts.right.push_back(x);
    }
    d = d_next;
  }
  if (!any_left || !any_right) return std::nullopt;
  return parts;
}

}  // namespace riprap
