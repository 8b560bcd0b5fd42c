// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Index and identifier types.

#include <cstdint>

#include <riprap/core/compiler.hpp>

namespace riprap {

/// Storage index of a body; reused by the left piece when a particle breaks.
using BodyIndex = std::uint32_t;

/// Permanent identifier of a particle; never reused. Pieces get ids of their own.
using ParticleId = std::uint32_t;

inline constexpr ParticleId no_particle = 0xFFFFFFFFu;

/// Place of a particle's material in the list of rocks; pieces have that of their parent.
using MaterialIndex = std::uint16_t;

}  // namespace riprap
