// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Weighted points for line fits.

#include <vector>

#include <riprap/breakage/line_fit/concepts.hpp>

namespace riprap::test {

using Cloud = std::vector<WeightedPoint>;

/// The points (0,0), (1,1), (2,3) with safety factors 1, 1/2, 1/4: small enough to fit by hand.
[[nodiscard]] inline Cloud three_points() { return {{{0, 0}, 1}, {{1, 1}, 2}, {{2, 3}, 4}}; }

/// Seven points about no line in particular, with uneven weights.
[[nodiscard]] inline Cloud scattered_points() {
  return {{{0.1, 0.7}, 1.1}, {{-0.4, 0.2}, 2.3},  {{0.9, 1.2}, 1.0}, {{0.3, -0.8}, 1.7},
          {{1.4, 0.6}, 3.1}, {{-1.1, -0.5}, 1.2}, {{0.2, 0.1}, 1.9}};
}

template <class Map>
[[nodiscard]] Cloud mapped(Cloud cloud, Map&& map) {
  for (WeightedPoint& p : cloud) p.position = map(p.position);
  return cloud;
}

/// Sine of the angle between two undirected directions.
[[nodiscard]] inline double off_angle(const Vec2& p, const Vec2& q) {
  return std::abs(cross(p, q)) / (p.norm() * q.norm());
}

}  // namespace riprap::test
