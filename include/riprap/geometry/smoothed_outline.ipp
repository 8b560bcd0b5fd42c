// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/geometry/line_side.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/geometry/smoothed_outline.hpp>

namespace riprap {

namespace internal {

/// `count` points at equal distances along a ring, from its first vertex on.
[[nodiscard]] inline std::vector<Vec2> equidistant_points(Ring ring, std::size_t count) {
  const double step = perimeter(ring) / static_cast<double>(count);
  std::vector<Vec2> points;
  double before = 0;  // length of the edges up to vertex k
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2 edge = ring[next_vertex(k, ring.size())] - ring[k];
    const double length = edge.norm();
    while (points.size() < count && static_cast<double>(points.size()) * step <= before + length) {
      const double along = static_cast<double>(points.size()) * step - before;
      points.push_back(ring[k] + (along / length) * edge);
    }
    before += length;
  }
  return points;
}

}  // namespace internal

RIPRAP_INLINE Outline smoothed_outline(const Outline& outline, double half_width) {
  const double length = perimeter(outline.ring());
  require(half_width > 0 && half_width <= 0.25 * length, "half width of smoothing", half_width,
          "must be above 0 and at most a quarter of the perimeter");
  constexpr int reach = 8;
  const auto count = static_cast<std::size_t>(std::lround(reach * length / half_width));
  const std::vector<Vec2> points = internal::equidistant_points(outline.ring(), count);
  // Weight of a point j away in the parabola's value in the middle, of 2 reach + 1 points.
  const auto weight = [](int j) {
    return 3.0 * (3 * reach * reach + 3 * reach - 1 - 5 * j * j) /
           ((2 * reach - 1) * (2 * reach + 1) * (2 * reach + 3));
  };
  std::vector<Vec2> smoothed;
  for (std::size_t k = 0; k < count; ++k) {
    Vec2 mean{0, 0};
    for (int j = -reach; j <= reach; ++j)
      mean += weight(j) * points[(k + count + static_cast<std::size_t>(j + reach) - reach) % count];
    smoothed.push_back(mean);
  }
  return Outline(std::move(smoothed));
}

}  // namespace riprap
