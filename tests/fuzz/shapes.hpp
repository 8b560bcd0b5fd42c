// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Polygons from a fuzzer's bytes: of any size and place, with edges, corners and widths down to
/// the limits of ConvexPolygon.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <riprap/geometry/convex_polygon.hpp>

#include "input.hpp"

namespace riprap::fuzz {

/// Convex, counter-clockwise, but for round-off.
[[nodiscard]] inline std::vector<Vec2> convex_hull(std::vector<Vec2> points) {
  std::erase_if(points, [](const Vec2& p) { return !is_finite(p); });
  std::sort(points.begin(), points.end(), [](const Vec2& p, const Vec2& q) {
    return std::pair(p.x(), p.y()) < std::pair(q.x(), q.y());
  });
  std::vector<Vec2> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t first = hull.size();
    for (const Vec2& p : points) {
      while (hull.size() >= first + 2 &&
             !(cross(hull.back() - hull[hull.size() - 2], p - hull.back()) > 0))
        hull.pop_back();
      hull.push_back(p);
    }
    if (!hull.empty()) hull.pop_back();  // the first of the other side
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// Corners cut off at a share of their edges, down to the shortest edges of a ConvexPolygon.
[[nodiscard]] inline std::vector<Vec2> bevelled(const std::vector<Vec2>& ring, Input& input) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2& v = ring[i];
    const unsigned kind = input.byte();
    if (kind < 128) {
      out.push_back(v);
      continue;
    }
    const double share = std::ldexp(0.25 + kind % 4 / 8.0, -static_cast<int>(kind / 4 % 32));
    out.push_back(v + share * (ring[(i + ring.size() - 1) % ring.size()] - v));
    out.push_back(v + (kind % 2 == 0 ? share : 0.4 * input.share()) *
                          (ring[(i + 1) % ring.size()] - v));
  }
  return out;
}

[[nodiscard]] inline Rotation turn_from(Input& input) {
  switch (input.below(4)) {
  case 0:
    return {};
  case 1:
    return {0, 1};
  case 2:
    return Rotation::from_angle(input.tiny());
  default:
    return Rotation::from_angle(2 * std::numbers::pi * input.share());
  }
}

[[nodiscard]] inline std::vector<Vec2> plain_ring(Input& input) {
  std::vector<Vec2> ring;
  const unsigned kind = input.below(4);
  if (kind == 0) {  // on an ellipse
    const unsigned n = 3 + input.below(62);
    const bool jitter = input.yes();
    for (unsigned i = 0; i < n; ++i) {
      const double at = i + (jitter ? 0.9 * input.share() : 0);
      const Rotation turn = Rotation::from_angle(2 * std::numbers::pi * at / n);
      ring.push_back({turn.cosine, turn.sine});
    }
    return ring;
  }
  if (kind == 1) {  // on a parabola that may be nearly straight
    const unsigned n = 3 + input.below(20);
    const double height = std::ldexp(1, -static_cast<int>(input.below(32)));
    for (unsigned i = 0; i < n; ++i) {
      const double x = 2 * input.share() - 1;
      ring.push_back({x, height * x * x});
    }
    ring.push_back({input.number(), input.number()});
    return convex_hull(ring);
  }
  for (unsigned n = 3 + input.below(14); n > 0; --n)
    ring.push_back({input.number(), input.number()});
  return convex_hull(ring);
}

/// A ring that is a ConvexPolygon more often than not.
[[nodiscard]] inline std::vector<Vec2> ring_from(Input& input) {
  std::vector<Vec2> ring = plain_ring(input);
  const unsigned changes = input.byte();
  if ((changes & 1U) != 0) ring = bevelled(ring, input);
  if ((changes & 65U) == 65U) ring = bevelled(ring, input);
  const double thin = (changes & 2U) != 0 ? std::ldexp(1, -static_cast<int>(input.below(31))) : 1;
  const Rotation turn = (changes & 4U) != 0 ? turn_from(input) : Rotation{};
  double scale = 1;
  if ((changes & 8U) != 0) scale = std::ldexp(1 + input.share(), input.byte() - 128);
  if ((changes & 24U) == 24U) scale *= scale;  // up to 1e77
  Vec2 shift{0, 0};
  if ((changes & 32U) != 0) {
    const double far = std::ldexp(1, static_cast<int>(input.below(24)));
    shift = far * Vec2{input.number(), input.number()};
  }
  for (Vec2& v : ring) v = scale * (turn * Vec2{v.x(), thin * v.y()} + shift);
  return ring;
}

[[nodiscard]] inline std::optional<ConvexPolygon> polygon_from(Input& input) {
  return try_convex_polygon(ring_from(input));
}

/// By a triangle fan, in more digits than the library's.
[[nodiscard]] inline long double exact_area(Ring ring) {
  long double sum = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const auto from = [&](std::size_t k, int axis) {
      return static_cast<long double>(ring[k][axis]) - static_cast<long double>(ring[0][axis]);
    };
    sum += from(i, 0) * from(i + 1, 1) - from(i, 1) * from(i + 1, 0);
  }
  return sum / 2;
}

/// Of all coordinates.
[[nodiscard]] inline double largest_coordinate(Ring ring) {
  double largest = 0;
  for (const Vec2& v : ring) largest = std::max(largest, v.cwiseAbs().maxCoeff());
  return largest;
}

}  // namespace riprap::fuzz
