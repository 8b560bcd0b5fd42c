// SPDX-License-Identifier: BSL-1.0
#include <cmath>

#include <riprap/contact/broad_phase/no_pairs.hpp>
#include <riprap/dynamics/damping/no_damping.hpp>
#include <riprap/dynamics/time_step/fixed_time_step.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct Centrifuge {  // about the origin, seen by an observer who turns with it
  double spin = 10;  // [rad/s]
  Vec2 operator()(const Body& body) const {
    const Vec2 coriolis = 2 * spin * Vec2{body.velocity.y(), -body.velocity.x()};
    return spin * spin * body.position + coriolis;
  }
};
static_assert(BodyForce<Centrifuge>);

int main() {
  const Assembly one{.particles = {{ConvexPolygon{{0.99, -0.01}, {1.02, 0}, {0.99, 0.01}}}}};
  Simulation sim{Model{}
                     .body_force(Centrifuge{})
                     .broad_phase(NoPairs{})
                     .damping(NoDamping{})
                     .time_step(FixedTimeStep{.seconds = 1e-6})
                     .criterion(NeverFails{}),
                 one, Rock{}};
  while (sim.time() < 0.1) sim.step();
  // Seen from outside a body at rest there keeps its velocity: it moves along a straight line.
  const double distance = sim.particles().body(0).position.norm();
  return std::abs(distance - std::sqrt(1 + std::pow(10 * 0.1, 2))) < 1e-3 ? 0 : 1;
}
