#pragma once
/// @file
/// Do two convex rings keep apart, and if not, what is the least translation that parts them?

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include <riprap/core/vec2.hpp>

namespace riprap {

/// An edge of one of two rings, remembered from step to step.
struct SeparatingEdge {
  bool of_b = false;
  std::uint8_t edge = 0;
};

/// True if all of `other` lies strictly outside edge `i` of `ring`.
[[nodiscard]] inline bool edge_separates(Ring ring, std::size_t i, Ring other) {
  const Vec2 p = ring[i];
  const Vec2 edge = ring[i + 1 == ring.size() ? 0 : i + 1] - p;
  for (const Vec2& v : other)
    if (cross(edge, v - p) >= 0) return false;
  return true;
}

/// True if an edge of a or b parts the two convex rings; `memory` holds the edge that did so last
/// and is tried first (two resting neighbours cost one edge test a step).
[[nodiscard]] inline bool separated(Ring a, Ring b, SeparatingEdge& memory) {
  const std::size_t remembered = memory.edge;
  if (remembered < (memory.of_b ? b.size() : a.size()) &&
      (memory.of_b ? edge_separates(b, remembered, a) : edge_separates(a, remembered, b)))
    return true;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (edge_separates(a, i, b)) {
      memory = {false, static_cast<std::uint8_t>(i)};
      return true;
    }
  for (std::size_t i = 0; i < b.size(); ++i)
    if (edge_separates(b, i, a)) {
      memory = {true, static_cast<std::uint8_t>(i)};
      return true;
    }
  return false;
}

/// The direction in which two overlapping rings are least entangled.
struct MinimumTranslation {
  double depth = 0;   ///< [m]; negative: the rings are that far apart along `normal`
  Vec2 normal{1, 0};  ///< unit vector from a to b: shifting b by depth * normal parts them
};

/// Separating-axis search over the edge normals of two convex rings; exact for overlapping ones.
[[nodiscard]] inline MinimumTranslation minimum_translation(Ring a, Ring b) {
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
