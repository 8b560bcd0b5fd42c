// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Separating edge and minimum translation of two convex rings.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <riprap/core/linkage.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/geometry/line_side.hpp>

namespace riprap {

/// An edge of one of two rings that separates them, cached from step to step.
struct SeparatingEdge {
  bool of_b = false;
  std::uint8_t edge = 0;
  double gap = 0;  ///< the rings were at least so far apart when the edge last separated them [m]
};

/// How far all of `other` lies outside edge `i` of `ring` [m]; not positive if it does not.
[[nodiscard]] inline double gap_beyond(Ring ring, std::size_t i, Ring other) {
  const LineSide edge(ring[i], ring[next_vertex(i, ring.size())]);
  double deepest = edge(other[0]);
  for (std::size_t k = 1; k < other.size(); ++k) deepest = std::max(deepest, edge(other[k]));
  return -deepest / std::sqrt(edge.x * edge.x + edge.y * edge.y);
}

/// True if all of `other` lies strictly outside edge `i` of `ring`.
[[nodiscard]] inline bool edge_separates(Ring ring, std::size_t i, Ring other) {
  const LineSide edge(ring[i], ring[next_vertex(i, ring.size())]);
  for (const Vec2& v : other)
    if (edge(v) >= 0) return false;
  return true;
}

/// Searches for an edge of a or b that separates the two convex rings, and caches it. True if
/// there is one.
[[nodiscard]] inline bool find_separating_edge(Ring a, Ring b, SeparatingEdge& cache) {
  const auto search = [&cache](Ring ring, Ring other, bool of_b) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (!edge_separates(ring, i, other)) continue;
      cache = {of_b, static_cast<std::uint8_t>(i), gap_beyond(ring, i, other)};
      return true;
    }
    return false;
  };
  return search(a, b, false) || search(b, a, true);
}

/// True if an edge of a or b separates the two convex rings; `cache` holds the edge that did so
/// last and is tried first.
[[nodiscard]] inline bool separated(Ring a, Ring b, SeparatingEdge& cache) {
  const Ring ring = cache.of_b ? b : a;
  const Ring other = cache.of_b ? a : b;
  if (cache.edge < ring.size() && edge_separates(ring, cache.edge, other)) {
    cache.gap = gap_beyond(ring, cache.edge, other);
    return true;
  }
  return find_separating_edge(a, b, cache);
}

/// Minimum translation that separates two overlapping rings.
struct MinimumTranslation {
  double depth = 0;   ///< [m]; negative: the rings are that far apart along `normal`
  Vec2 normal{1, 0};  ///< unit vector from a to b: shifting b by depth * normal separates them
};

/// Separating-axis search over the edge normals of two convex rings; exact for overlapping ones.
[[nodiscard]] MinimumTranslation minimum_translation(Ring a, Ring b);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/geometry/separation.ipp>
#endif
