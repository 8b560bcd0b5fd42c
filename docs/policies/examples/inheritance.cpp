// SPDX-License-Identifier: BSL-1.0
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct WithoutSpin {  // pieces keep their share of the momentum and lose their spin
  void operator()(const Body& parent, Body& piece) const {
    piece.velocity = parent.velocity_at(piece.position - parent.position);
    piece.angular_velocity = 0;
  }
};

struct AtBreak {  // sees the pieces before they have moved
  double spin = 1;
  void after_splits(const auto& sim) { spin = sim.particles().body(0).angular_velocity; }
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon platen{{-0.02, 0}, {0.04, 0}, {0.04, 0.016}, {-0.02, 0.016}};
  const Assembly pressed{.particles = {{square},  // 1 mm deep in a platen on either side
                                       {platen.moved({}, {0, 0.0150}), Motion::prescribed},
                                       {platen.moved({}, {0, -0.0150}), Motion::prescribed}}};
  Simulation sim{Model{}.inheritance(WithoutSpin{}), pressed, Rock{}};
  sim.set_velocity(0, Vec2{0, 0}, 1.0);
  AtBreak at_break;
  for (int i = 0; i < 3; ++i) sim.step(at_break);
  return at_break.spin == 0 ? 0 : 1;
}
