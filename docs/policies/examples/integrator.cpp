#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct WithoutTurning {  // symplectic Euler for bodies that do not turn, as if on rails
  static constexpr int order = 1;
  static constexpr bool needs_finish = false;
  void advance(Body& body, const Wrench& wrench, double time_step) const {
    kick(body, {wrench.force, 0}, time_step);
    drift(body, time_step);
  }
  void finish(Body&, const Wrench&, double) const {}
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const Assembly pair{.particles = {{square},  // pushed by its upper right corner
                                    {square.moved({}, {0.0155, 0.012}), Motion::prescribed}}};
  Simulation sim{Model{}.integrator(WithoutTurning{}).criterion(NeverFails{}), pair, Rock{}};
  for (int i = 0; i < 20; ++i) sim.step();
  const Body& body = sim.particles().body(0);
  return body.velocity.x() < 0 && body.rotation.sine == 0 ? 0 : 1;
}
