// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Loose rectangular assemblies of random sharp polygons: between four platens, or in a periodic
/// cell.

#include <cmath>
#include <utility>

#include <riprap/core/linkage.hpp>
#include <riprap/particle/random_placement.hpp>

namespace riprap {

namespace internal {

/// Platens or walls around a rectangle, twice as long as its sides: right, left, top, bottom.
/// @param half of its width and height [m]
[[nodiscard]] Assembly four_platens(const RandomAssembly& options, const Vec2& half);

}  // namespace internal

/// Places polygons at random without overlap in a rectangle about the origin, between four platens
/// or walls (ids 0 to 3: right, left, top, bottom) that are twice as long as its sides. For
/// RigidPlatens. Same seed, same bytes; of the options, those of the ring have no effect.
[[nodiscard]] Assembly random_platen_assembly(const RandomAssembly& options);

/// Places polygons at random without overlap in a periodic rectangular cell. For PeriodicCell. Same
/// seed, same bytes; of the options, those of the ring have no effect.
[[nodiscard]] Assembly random_periodic_assembly(const RandomAssembly& options);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/particle/random_box_assembly.ipp>
#endif
