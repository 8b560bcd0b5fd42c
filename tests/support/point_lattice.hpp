// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Points at random that lie about evenly.

#include <cstdint>
#include <vector>

#include <riprap/core/vec2.hpp>

namespace riprap::test {

/// n by n points in a square of side `size` [m] from the origin, each moved from the middle of its
/// cell by up to `share` of the width of a cell along both axes.
[[nodiscard]] inline std::vector<Vec2> shaken_lattice(unsigned n, double size, double share) {
  std::uint64_t state = 12345;
  const auto next = [&] {  // in [-1, 1)
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 11) * 0x1p-52 - 1;
  };
  std::vector<Vec2> out;
  for (unsigned i = 0; i < n; ++i)
    for (unsigned j = 0; j < n; ++j) {
      const double x = i + 0.5 + share * next();
      const double y = j + 0.5 + share * next();
      out.emplace_back(size / n * x, size / n * y);
    }
  return out;
}

}  // namespace riprap::test
