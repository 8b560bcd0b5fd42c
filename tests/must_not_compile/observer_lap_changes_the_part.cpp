// SPDX-License-Identifier: BSL-1.0
// riprap: an observer has a hook that cannot be called with a const reference to what hooks get
// (docs/policies/observer.md)
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct Mine {
  void on_phase_end(StepPhase&) {}
};

void run(Simulation<Model<>>& sim, Mine& observer) { sim.step(observer); }
