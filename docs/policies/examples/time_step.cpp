// SPDX-License-Identifier: BSL-1.0
#include <algorithm>

#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct GivenStep {        // the same step for every sample; lighter bodies are made to bear it
  double seconds = 1e-6;  // [s]
  double time_step(double /*mass*/, double /*stiffness*/) const { return seconds; }
  double mass_scaling(double mass, double smallest) const { return std::max(1.0, smallest / mass); }
  void validate() const { require_positive("GivenStep.seconds", seconds); }
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const Assembly single{.particles = {{square}}};
  Simulation sim{Model{}.time_step(GivenStep{.seconds = 5e-7}).criterion(NeverFails{}), single,
                 Rock{}};
  for (int i = 0; i < 3; ++i) sim.step();
  return sim.time_step() == 5e-7 ? 0 : 1;
}
