// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include <riprap/geometry/cut.hpp>

namespace riprap {

namespace internal {

/// Sides of the vertices of a convex ring: 1 left of the line, -1 right of it, 0 at an end of the
/// cut. Of neighbouring vertices within `snap` of the line the nearest one is an end; the others
/// keep to the side of the ring that they continue, so that no edge becomes part of both pieces.
/// Empty unless the ring changes sides exactly twice.
[[nodiscard]] RIPRAP_INLINE std::vector<signed char> cut_sides(std::span<const double> distances,
                                                               double snap) {
  const std::size_t n = distances.size();
  std::vector<signed char> sides;
  sides.reserve(n);
  for (const double d : distances)
    sides.push_back(static_cast<signed char>(std::abs(d) <= snap ? 0 : d > 0 ? 1 : -1));
  std::size_t first = 0;
  while (first < n && sides[first] == 0) ++first;
  if (first == n) return {};
  int changes = 0;
  std::size_t last = first;  // vertex clear of the line
  for (std::size_t k = first + 1; k <= first + n; ++k) {
    const signed char side = sides[k % n];
    if (side == 0) continue;
    std::size_t end = k;
    if (side != sides[last % n]) {
      ++changes;
      for (std::size_t m = last + 1; m < k; ++m)
        if (end == k || std::abs(distances[m % n]) < std::abs(distances[end % n])) end = m;
    }
    for (std::size_t m = last + 1; m < k; ++m)
      if (m != end) sides[m % n] = m < end ? sides[last % n] : side;
    last = k;
  }
  if (changes != 2) return {};
  return sides;
}

/// Area in extended precision, for rings whose width is a small share of their length.
[[nodiscard]] RIPRAP_INLINE long double extended_area(Ring ring) {
  const auto from_first = [&](std::size_t i, Eigen::Index axis) {
    return static_cast<long double>(ring[i][axis]) - static_cast<long double>(ring[0][axis]);
  };
  long double twice_area = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    twice_area += from_first(i, 0) * from_first(i + 1, 1) - from_first(i, 1) * from_first(i + 1, 0);
  return twice_area / 2;
}

/// The point that divides the edge from p to q at `share`. Coordinates are rounded, so the point
/// lies beside the edge and makes a triangle with it, whose area the pieces gain or lose. Where
/// twice that area is above `negligible` [m^2], the best of 128 points near it on the edge is
/// taken.
[[nodiscard]] RIPRAP_INLINE Vec2 point_on_edge(const Vec2& p, const Vec2& q, double share,
                                               double negligible) {
  const Vec2 edge = q - p;
  Vec2 best = p + share * edge;
  double least = std::abs(cross(edge, best - p));
  const double step = 1e-8 * std::min(share, 1 - share);
  for (int k = 1; k <= 64 && least > negligible; ++k)
    for (const int side : {-k, k}) {
      const Vec2 x = p + (share + side * step) * edge;
      const double twice_area = std::abs(cross(edge, x - p));
      if (twice_area >= least) continue;
      least = twice_area;
      best = x;
    }
  return best;
}

RIPRAP_INLINE std::optional<CutRings> divide(Ring ring, const Line& line, double snap) {
  std::vector<double> distances;
  distances.reserve(ring.size());
  for (const Vec2& v : ring) distances.push_back(line.left_distance(v));
  const std::vector<signed char> sides = cut_sides(distances, snap);
  if (sides.empty()) return std::nullopt;
  const double negligible = 4e-13 * polygon_area(ring);
  CutRings parts;
  parts.left.reserve(ring.size() + 1);
  parts.right.reserve(ring.size() + 1);
  std::vector<Vec2> ends;
  ends.reserve(2);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (sides[i] >= 0) parts.left.push_back(ring[i]);
    if (sides[i] <= 0) parts.right.push_back(ring[i]);
    if (sides[i] == 0) ends.push_back(ring[i]);
    const std::size_t next = (i + 1) % ring.size();
    if (sides[i] * sides[next] >= 0) continue;
    const double share = distances[i] / (distances[i] - distances[next]);
    ends.push_back(point_on_edge(ring[i], ring[next], share, negligible));
    // Without a snap distance an end may be rounded to a vertex, which one piece then has already.
    const bool leaves_left = sides[i] > 0;
    if (ends.back() != ring[leaves_left ? i : next]) parts.left.push_back(ends.back());
    if (ends.back() != ring[leaves_left ? next : i]) parts.right.push_back(ends.back());
  }
  if (ends.front() == ends.back() || parts.left.size() < 3 || parts.right.size() < 3)
    return std::nullopt;
  return parts;
}

}  // namespace internal

RIPRAP_INLINE std::optional<CutRings> cut(Ring ring, const Line& line, double relative_snap) {
  const double size = diameter(ring);
  std::optional<CutRings> parts = internal::divide(ring, line, relative_snap * size);
  if (!parts) return std::nullopt;
  const long double area = internal::extended_area(ring);
  const long double miss =
      internal::extended_area(parts->left) + internal::extended_area(parts->right) - area;
  const long double round_off =
      4 * std::numeric_limits<long double>::epsilon() * static_cast<long double>(size * size);
  if (!(std::abs(miss) + round_off <= 1e-12L * area)) return std::nullopt;
  return parts;
}

}  // namespace riprap
