// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Sorting by keys.

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include <riprap/core/compiler.hpp>
#include <riprap/core/linkage.hpp>

namespace riprap {

/// Indices that sort `keys` in ascending order; stable. No key may be NaN. One function for all
/// keys, since every further comparison instantiates a sort of its own.
[[nodiscard]] std::vector<std::size_t> argsort(std::span<const double> keys);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/core/argsort.ipp>
#endif
