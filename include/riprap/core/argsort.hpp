// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Sorting by keys.

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <riprap/compiler.hpp>

namespace riprap {

/// Indices that sort `keys` in ascending order; stable. No key may be NaN. One function for all
/// keys, since every further comparison instantiates a sort of its own.
[[nodiscard]] inline std::vector<std::size_t> argsort(std::span<const double> keys) {
  std::vector<std::pair<double, std::size_t>> sorted;
  for (std::size_t i = 0; i < keys.size(); ++i) sorted.emplace_back(keys[i], i);
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::size_t> order;
  for (const auto& [key, i] : sorted) order.push_back(i);
  return order;
}

}  // namespace riprap
