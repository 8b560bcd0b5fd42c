// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Spatial sorting: neighbours in space become neighbours in memory.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <riprap/core/argsort.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/particle/assembly.hpp>

namespace riprap {

namespace internal {

/// Index along the Z-order curve through a grid of 2^32 by 2^32 cells (Morton 1966): the bits of
/// both coordinates interleaved.
[[nodiscard]] std::uint64_t morton_code(std::uint32_t column, std::uint32_t row);

}  // namespace internal

namespace internal {}  // namespace internal

/// Sorts particles along a space-filling curve, so that the bodies of a contact are close in memory
/// and most contacts have both in one task. Random assemblies are sorted; sort a large one of your
/// own before the simulation is made.
void sort_by_morton_code(std::span<PlacedParticle> particles);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/particle/spatial_order.ipp>
#endif
