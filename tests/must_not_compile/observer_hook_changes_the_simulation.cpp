// SPDX-License-Identifier: BSL-1.0
// riprap: an observer has a hook that cannot be called with a const reference to what hooks get
// (docs/policies/observer.md)
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct Mine {
  void after_step(Simulation<Model<>>&) {}
};

void run(Simulation<Model<>>& sim, Mine& observer) { sim.step(observer); }
