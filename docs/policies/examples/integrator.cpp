// SPDX-License-Identifier: BSL-1.0
#include <riprap/conformance/integrator.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct DriftThenKick {  // symplectic Euler the other way round: motion first, then the new forces
  static constexpr int order = 1;
  static constexpr bool has_second_kick = true;
  void advance(Body& body, const Wrench&, double time_step) const { drift(body, time_step); }
  void second_kick(Body& body, const Wrench& wrench, double time_step) const {
    kick(body, wrench, time_step);
  }
  // All of the impulse, and its work, is in second_kick.
  double first_kick_fraction() const { return 0; }
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const Assembly pair{.particles = {{square},  // pushed by its upper right corner
                                    {square.moved({}, {0.0155, 0.012}), Motion::prescribed}}};
  Simulation sim{Model{}.integrator(DriftThenKick{}).criterion(NeverFails{}), pair, Rock{}};
  for (int i = 0; i < 20; ++i) sim.step();
  const Body& body = sim.particles().body(0);
  const bool pushed = body.velocity.x() < 0 && body.angular_velocity > 0;
  return pushed && integrator_violations(DriftThenKick{}).empty() ? 0 : 1;
}
