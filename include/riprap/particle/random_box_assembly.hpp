// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Loose square assemblies of random sharp polygons: between four platens, or in a periodic cell.

#include <cmath>
#include <utility>

#include <riprap/core/linkage.hpp>
#include <riprap/particle/random_placement.hpp>

namespace riprap {
namespace internal {}  // namespace internal

/// Places polygons at random without overlap in a square about the origin, between four platens
/// (ids 0 to 3) that are twice as long as the square is wide. For RigidPlatens. Same seed, same
/// bytes; of the options, those of the ring have no effect.
[[nodiscard]] Assembly random_platen_assembly(const RandomAssembly& options);

/// Places polygons at random without overlap in a periodic square cell. For PeriodicCell. Same
/// seed, same bytes; of the options, those of the ring have no effect.
[[nodiscard]] Assembly random_periodic_assembly(const RandomAssembly& options);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/particle/random_box_assembly.ipp>
#endif
