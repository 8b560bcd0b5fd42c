// SPDX-License-Identifier: BSL-1.0
#pragma once
// A square particle between two platens that approach each other along axis 2.

#include <riprap/particle/assembly.hpp>

namespace riprap::test {

/// Particle 0 is the square (side 16 mm, centre at the origin), 1 and 2 are the platens.
/// @param speed of each platen [m/s]
inline Assembly square_between_platens(double speed) {
  const double h = 0.008;
  const double w = 0.02;
  Assembly assembly{.thickness = 0.016, .particles = {}};
  assembly.particles.push_back({ConvexPolygon{{-h, -h}, {h, -h}, {h, h}, {-h, h}}, Motion::free});
  assembly.particles.push_back({ConvexPolygon{{-w, h}, {w, h}, {w, 2 * h}, {-w, 2 * h}},
                                Motion::prescribed, Vec2{0, -speed}});
  assembly.particles.push_back({ConvexPolygon{{-w, -2 * h}, {w, -2 * h}, {w, -h}, {-w, -h}},
                                Motion::prescribed, Vec2{0, speed}});
  return assembly;
}

}  // namespace riprap::test
