// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct QuadraticDrag {      // against the motion, with the square of the speed; turning is free
  double coefficient = 10;  // force over speed squared [kg/m]
  Wrench operator()(const Body& body, const Wrench& /*applied*/) const {
    return {-(coefficient * body.velocity.norm()) * body.velocity, 0};
  }
  void validate() const { require_non_negative("QuadraticDrag.coefficient", coefficient); }
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const Assembly thrown{.particles = {{square, Motion::free, Vec2{2, 0}}}};
  Simulation sim{Model{}.damping(QuadraticDrag{}).criterion(NeverFails{}), thrown, Rock{}};
  for (int i = 0; i < 200; ++i) sim.step();
  const Body& body = sim.particles().body(0);
  const double expected = 1 / (1 / 2.0 + 10 * sim.time() / body.mass);  // of m dv/dt = -c v^2
  return std::abs(body.velocity.x() / expected - 1) < 0.01 ? 0 : 1;
}
