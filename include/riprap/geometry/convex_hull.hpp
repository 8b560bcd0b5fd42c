// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The convex hull of points. Optional: not part of riprap.hpp.

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include <riprap/core/vec2.hpp>

namespace riprap {

/// Corners of the convex hull [m], counter-clockwise from the lowest of those farthest to the left;
/// points within its edges are left out (A. M. Andrew, Inf. Process. Lett. 9, 1979). Points on a
/// line give their two ends.
[[nodiscard]] inline std::vector<Vec2> convex_hull(std::span<const Vec2> points) {
  std::vector<Vec2> sorted(points.begin(), points.end());
  std::sort(sorted.begin(), sorted.end(), [](const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  if (sorted.size() < 3) return sorted;
  std::vector<Vec2> hull;
  const auto add = [&hull](const Vec2& p, std::size_t fewest) {
    while (hull.size() > fewest && cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
      hull.pop_back();
    hull.push_back(p);
  };
  for (const Vec2& p : sorted) add(p, 1);
  const std::size_t lower = hull.size();
  for (std::size_t k = sorted.size() - 1; k-- > 0;) add(sorted[k], lower);
  hull.pop_back();
  return hull;
}

}  // namespace riprap
