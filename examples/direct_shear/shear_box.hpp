// SPDX-License-Identifier: BSL-1.0
#pragma once
// A shear box of six walls: two halves, each a rough plate with two sides. The lower half moves
// along axis 1, the upper plate is the lid that carries the normal force and moves along axis 2
// alone, the upper sides stand still.

#include <array>
#include <vector>

#include <riprap/core/vec2.hpp>
#include <riprap/particle/assembly.hpp>

namespace direct_shear {

// Indices of the walls, which are the first bodies of the assembly.
enum Wall : riprap::BodyIndex {
  lower_plate,
  lower_left,
  lower_right,
  lid,
  upper_left,
  upper_right,
  walls
};

// The floor lies on axis 1, the box is symmetric about axis 2.
struct BoxSize {
  double width = 0;      // between the sides [m]
  double height = 0;     // from the floor to the lid at the start [m]
  double parting = 0;    // height of the plane between the halves [m]
  double thickness = 0;  // of the walls; more than the lower half moves [m]
};

// The six walls in the order of their indices; the sides rough (Motion::wall) or smooth
// (Motion::platen).
[[nodiscard]] std::vector<riprap::PlacedParticle> box_walls(const BoxSize& size,
                                                            riprap::Motion sides);

// What the walls carry [N]; the shear forces are those along axis 1 that drive the lower half and
// hold the upper one, the normal forces press the halves together: what the lid pushes with, and
// what goes through the parting plane, which is less by the friction on the upper sides.
struct BoxForces {
  double shear_lower = 0;
  double shear_upper = 0;
  double normal_lid = 0;
  double normal_plane = 0;

  BoxForces& operator+=(const BoxForces& o);
  [[nodiscard]] friend BoxForces operator*(double f, const BoxForces& b) {
    return {f * b.shear_lower, f * b.shear_upper, f * b.normal_lid, f * b.normal_plane};
  }
};

template <class Sim>
[[nodiscard]] BoxForces forces(const Sim& sim) {
  const auto sum = [&](std::initializer_list<Wall> bodies) {
    riprap::Vec2 f{0, 0};
    for (const Wall w : bodies) f += sim.force_on(w).force;
    return f;
  };
  const riprap::Vec2 lower = sum({lower_plate, lower_left, lower_right});
  const riprap::Vec2 upper = sum({lid, upper_left, upper_right});
  return {.shear_lower = -lower.x(),
          .shear_upper = upper.x(),
          .normal_lid = sim.force_on(lid).force.y(),
          .normal_plane = -lower.y()};
}

// Gives the lower half a velocity along axis 1 [m/s].
template <class Sim>
void move_lower_half(Sim& sim, double velocity) {
  for (const Wall w : {lower_plate, lower_left, lower_right}) sim.set_velocity(w, {velocity, 0});
}

}  // namespace direct_shear
