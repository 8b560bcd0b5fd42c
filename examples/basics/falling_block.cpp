// SPDX-License-Identifier: BSL-1.0
// falling_block: a block falls on a floor; the time of the fall beside sqrt(2 h / g)
// The smallest program: an assembly of two polygons, a model, and steps.

#include <cmath>
#include <cstdio>

#include <riprap/riprap.hpp>
using namespace riprap;

int main() {
  const double height = 0.05;   // [m]
  const double gravity = 9.81;  // [m/s^2]
  const ConvexPolygon block{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon floor{{-0.1, -0.01}, {0.1, -0.01}, {0.1, 0}, {-0.1, 0}};
  const Assembly assembly{
      .particles = {{block.moved({}, {0, height})}, {floor, Motion::prescribed}}};

  // No breakage and no damping: Newton's law alone.
  Simulation sim{Model{}.criterion(NeverFails{}).damping(NoDamping{}), assembly, Rock{}};
  sim.set_body_force({0, -gravity});
  while (sim.particles().body(0).contact.force.y() == 0) sim.step();

  const double expected = std::sqrt(2 * height / gravity);
  std::printf("time of fall %.6f s, closed form %.6f s, time step %.1e s\n", sim.time(), expected,
              sim.time_step());
  // The contact is found at the end of a step, and the integrator is of first order in the step.
  return std::abs(sim.time() - expected) <= 2 * sim.time_step() ? 0 : 1;
}
