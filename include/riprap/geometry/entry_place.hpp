// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Where one convex ring has entered another through a single edge.

#include <cstddef>
#include <cstdint>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/line_side.hpp>

namespace riprap {

/// One or two neighbouring vertices of the entering ring lie beyond an edge of the other. All
/// vertices that have a part in it, by their numbers, so that a pair that stays as it is need not
/// look for them again (25 instructions of a contact).
struct EntryPlace {
  std::uint8_t ring_size = 0;   ///< of the ring with the edge; 0: nowhere
  std::uint8_t other_size = 0;  ///< of the ring that enters
  std::uint8_t edge = 0;        ///< where it begins
  std::uint8_t edge_end = 0;
  std::uint8_t across = 0;  ///< vertex of the ring opposite to the edge
  std::uint8_t first = 0;   ///< of the entering ring, beyond the edge
  std::uint8_t last = 0;    ///< the same as `first`, or the next
  std::uint8_t before = 0;  ///< its neighbours, on this side of the edge
  std::uint8_t after = 0;

  [[nodiscard]] bool one_vertex() const { return first == last; }
  /// Whether rings are of the sizes that it was made for.
  [[nodiscard]] bool fits(Ring ring, Ring other) const {
    return ring.size() == ring_size && other.size() == other_size;
  }
};

/// Of rings of `n` and `m` vertices: `count` vertices of the second, from `first` on, lie beyond
/// the edge of the first that begins at vertex `edge`.
[[nodiscard]] inline EntryPlace entry_place(std::size_t n, std::size_t edge, std::size_t m,
                                            std::size_t first, std::size_t count) {
  const auto number = [](std::size_t k) { return static_cast<std::uint8_t>(k); };
  const std::size_t last = count == 1 ? first : next_vertex(first, m);
  return {.ring_size = number(n),
          .other_size = number(m),
          .edge = number(edge),
          .edge_end = number(next_vertex(edge, n)),
          .across = number((edge + n / 2 + 1) % n),
          .first = number(first),
          .last = number(last),
          .before = number(previous_vertex(first, m)),
          .after = number(next_vertex(last, m))};
}

}  // namespace riprap
