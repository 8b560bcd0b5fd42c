// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct Witness {
  double strongest = 0;  // largest normal force seen [N]
  double smallest = 1;   // area of the smallest piece born [m^2]
  void after_forces(const auto& sim) {
    sim.contacts().for_each_touching(
        [&](const auto& contact) { strongest = std::max(strongest, contact.force.normal); });
  }
  void on_break(const auto& /*sim*/, const BreakEvent& event) {
    smallest = std::min({smallest, event.areas[0], event.areas[1]});
  }
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon platen{{-0.02, 0}, {0.04, 0}, {0.04, 0.016}, {-0.02, 0.016}};
  const Assembly pressed{.particles = {{square},  // 1 mm deep in a platen on either side
                                       {platen.moved({}, {0, 0.0150}), Motion::prescribed},
                                       {platen.moved({}, {0, -0.0150}), Motion::prescribed}}};
  Simulation sim{Model{}, pressed, Rock{}};
  Witness witness;
  for (int i = 0; i < 3; ++i) sim.step(witness);
  return witness.strongest > 0 && witness.smallest < 0.016 * 0.016 ? 0 : 1;
}
