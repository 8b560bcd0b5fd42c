// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A bond between two particles before the simulation starts.

#include <array>
#include <cstddef>

#include <riprap/core/vec2.hpp>
#include <riprap/particle/domain.hpp>

namespace riprap {

/// Two placed particles that are joined along an edge; free of force where they are placed.
struct PlacedBond {
  std::size_t a = 0;  ///< place in Assembly::particles
  std::size_t b = 0;
  std::array<Vec2, 2> ends{Vec2{0, 0}, Vec2{0, 0}};  ///< of the edge, at particle a [m]
  PeriodicDomain::Image image{};  ///< the copy of b that is joined to a, in a periodic cell
};

}  // namespace riprap
