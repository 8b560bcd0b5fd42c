// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Triangles of listed points.

#include <array>
#include <cstdint>

#include <riprap/core/compiler.hpp>

namespace riprap {

/// Three points by their places in a list, counter-clockwise.
using TriangleIndices = std::array<std::uint32_t, 3>;

}  // namespace riprap
