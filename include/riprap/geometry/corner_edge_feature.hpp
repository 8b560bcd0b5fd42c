// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The vertices that take part in a corner-edge overlap, by index.

#include <cstddef>
#include <cstdint>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/line_side.hpp>

namespace riprap {

/// One or two neighbouring vertices of the penetrating ring lie beyond an edge of the other. The
/// indices of all vertices that take part, so that they need not be searched again at the next
/// step.
struct CornerEdgeFeature {
  std::uint8_t ring_size = 0;   ///< of the ring with the edge; 0: no feature
  std::uint8_t other_size = 0;  ///< of the penetrating ring
  std::uint8_t edge = 0;        ///< where it begins
  std::uint8_t edge_end = 0;
  std::uint8_t opposite = 0;  ///< vertex of the ring opposite to the edge
  std::uint8_t first = 0;     ///< of the penetrating ring, beyond the edge
  std::uint8_t last = 0;      ///< the same as `first`, or the next
  std::uint8_t before = 0;    ///< its neighbours, on this side of the edge
  std::uint8_t after = 0;

  [[nodiscard]] bool one_vertex() const { return first == last; }
  /// Whether the feature was made for rings of these sizes.
  [[nodiscard]] bool fits(Ring ring, Ring other) const {
    return ring.size() == ring_size && other.size() == other_size;
  }
};

/// Of rings of `n` and `m` vertices: `count` vertices of the second, from `first` on, lie beyond
/// the edge of the first that begins at vertex `edge`.
[[nodiscard]] inline CornerEdgeFeature corner_edge_feature(std::size_t n, std::size_t edge,
                                                           std::size_t m, std::size_t first,
                                                           std::size_t count) {
  const auto number = [](std::size_t k) { return static_cast<std::uint8_t>(k); };
  const std::size_t last = count == 1 ? first : next_vertex(first, m);
  return {.ring_size = number(n),
          .other_size = number(m),
          .edge = number(edge),
          .edge_end = number(next_vertex(edge, n)),
          .opposite = number((edge + n / 2 + 1) % n),
          .first = number(first),
          .last = number(last),
          .before = number(previous_vertex(first, m)),
          .after = number(next_vertex(last, m))};
}

}  // namespace riprap
