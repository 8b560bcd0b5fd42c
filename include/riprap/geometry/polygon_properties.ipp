// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <riprap/geometry/polygon_properties.hpp>

namespace riprap {

RIPRAP_INLINE AreaProperties area_properties(Ring ring) {
  if (ring.size() < 3) return {0, ring.empty() ? Vec2{0, 0} : ring[0], 0};
  const Vec2 origin = ring[0];
  double twice_area = 0;
  Vec2 first{0, 0};
  double second = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Vec2 p = ring[i] - origin;
    const Vec2 q = ring[i + 1] - origin;
    const double t = cross(p, q);
    twice_area += t;
    first += t * (p + q);
    second += t * (p.dot(p) + p.dot(q) + q.dot(q));
  }
  const Vec2 c = twice_area != 0 ? Vec2(first / (3 * twice_area)) : Vec2{0, 0};
  const double area = 0.5 * twice_area;
  return {area, origin + c, second / 12 - area * c.dot(c)};
}

RIPRAP_INLINE double polygon_area(Ring ring) {
  double twice_area = 0;
  for (std::size_t i = 1; i + 1 < ring.size(); ++i)
    twice_area += cross(ring[i] - ring[0], ring[i + 1] - ring[0]);
  return 0.5 * twice_area;
}

RIPRAP_INLINE double perimeter(Ring ring) {
  double length = 0;
  for (std::size_t k = 0; k < ring.size(); ++k)
    length += (ring[(k + 1) % ring.size()] - ring[k]).norm();
  return length;
}

RIPRAP_INLINE double diameter(Ring ring) {
  double squared = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    for (std::size_t j = i + 1; j < ring.size(); ++j)
      squared = std::max(squared, (ring[i] - ring[j]).squaredNorm());
  return std::sqrt(squared);
}

RIPRAP_INLINE double extent_along(Ring ring, const Vec2& axis) {
  double low = axis.dot(ring[0]);
  double high = low;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    const double s = axis.dot(ring[i]);
    low = std::min(low, s);
    high = std::max(high, s);
  }
  return high - low;
}

RIPRAP_INLINE double least_width(Ring ring) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 edge = ring[(i + 1) % ring.size()] - ring[i];
    double widest = 0;
    for (const Vec2& v : ring) widest = std::max(widest, cross(edge, v - ring[i]));
    least = std::min(least, widest / edge.norm());
  }
  return least;
}

}  // namespace riprap
