// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A loose circular or rectangular assembly of random sharp polygons inside a ring of boundary
/// particles.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <riprap/core/linkage.hpp>
#include <riprap/particle/random_placement.hpp>

namespace riprap {

namespace internal {

/// Extent across the direction of `at` [m].
[[nodiscard]] double tangential_extent(const ConvexPolygon& polygon, const Vec2& at);

}  // namespace internal

/// Places polygons at random without overlap inside a circle or a rectangle about the origin. The
/// first ones of the list form the boundary: a ring driven by the strain field. Same seed, same
/// bytes.
[[nodiscard]] Assembly random_assembly(const RandomAssembly& options);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/particle/random_assembly.ipp>
#endif
