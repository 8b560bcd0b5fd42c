// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <riprap/geometry/separation.hpp>

namespace riprap {

RIPRAP_INLINE MinimumTranslation minimum_translation(Ring a, Ring b) {
  MinimumTranslation best{std::numeric_limits<double>::infinity(), Vec2{1, 0}};
  const auto try_edges = [&best](Ring ring, Ring other, double sign) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 p = ring[i];
      const Vec2 edge = ring[i + 1 == ring.size() ? 0 : i + 1] - p;
      const Vec2 outward = -perpendicular(edge) / std::sqrt(edge.dot(edge));
      double deepest = -std::numeric_limits<double>::infinity();
      for (const Vec2& v : other) deepest = std::max(deepest, -outward.dot(v - p));
      if (deepest < best.depth) best = {deepest, sign * outward};
    }
  };
  try_edges(a, b, 1);
  try_edges(b, a, -1);
  return best;
}

}  // namespace riprap
