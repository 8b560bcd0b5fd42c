// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <numbers>
#include <vector>

#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct ShakingTable {     // driven bodies swing along axis 1
  double speed = 0.05;    // largest [m/s]
  double frequency = 50;  // [Hz]
  double time = 0;        // [s]
  void drive(std::vector<Body>& bodies, double time_step) {
    time += time_step;
    const double now = speed * std::sin(2 * std::numbers::pi * frequency * time);
    for (Body& body : bodies)
      if (body.motion == Motion::prescribed) body.velocity = Vec2{now, 0};
  }
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const Assembly stack{
      .particles = {{square, Motion::prescribed}, {square.moved({}, {0, 0.01599})}}};
  Simulation sim{Model{}.boundary(ShakingTable{}).criterion(NeverFails{}), stack, Rock{}};
  for (int i = 0; i < 100; ++i) sim.step();
  return sim.particles().body(1).velocity.x() > 0 ? 0 : 1;  // taken along by friction
}
