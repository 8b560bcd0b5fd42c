// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <utility>

#include <riprap/core/argsort.hpp>

namespace riprap {

RIPRAP_INLINE std::vector<std::size_t> argsort(std::span<const double> keys) {
  std::vector<std::pair<double, std::size_t>> sorted;
  for (std::size_t i = 0; i < keys.size(); ++i) sorted.emplace_back(keys[i], i);
  std::sort(sorted.begin(), sorted.end());
  std::vector<std::size_t> order;
  for (const auto& [key, i] : sorted) order.push_back(i);
  return order;
}

}  // namespace riprap
