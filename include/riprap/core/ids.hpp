// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Names for things that are counted.

#include <cstdint>

#include <riprap/compiler.hpp>

namespace riprap {

/// Place of a body in the storage. Changes owner when a particle breaks.
using BodyIndex = std::uint32_t;

/// A particle's name for life; never used again. Pieces get ids of their own.
using ParticleId = std::uint32_t;

inline constexpr ParticleId no_particle = 0xFFFFFFFFu;

}  // namespace riprap
