// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Squares that stand on a corner, whose boxes are as wide as they are.

#include <cstdint>

#include <riprap/core/random.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap::test {

[[nodiscard]] inline ConvexPolygon diamond(const Vec2& centre, double reach) {
  return {centre + Vec2{reach, 0}, centre + Vec2{0, reach}, centre - Vec2{reach, 0},
          centre - Vec2{0, reach}};
}

/// So many of them, with centres within `extent` of the origin along each axis.
[[nodiscard]] inline Particles scattered(unsigned count, double extent, double reach,
                                         std::uint64_t seed) {
  Random random(seed);
  Particles particles(1, 1);
  for (unsigned i = 0; i < count; ++i) {
    const double x = random.uniform(-extent, extent);
    particles.add(diamond({x, random.uniform(-extent, extent)}, reach), Motion::free);
  }
  return particles;
}

}  // namespace riprap::test
