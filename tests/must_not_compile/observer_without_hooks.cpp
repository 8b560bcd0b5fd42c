// SPDX-License-Identifier: BSL-1.0
// riprap: an observer of a step must have one of the hooks on_phase_end, before_forces,
// after_forces, before_splits, on_break, on_bond_break, after_splits, after_step
// (docs/policies/observer.md)
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct Mine {
  void after_stpe(const auto& /*sim*/) {}
};

void run(Simulation<Model<>>& sim, Mine& observer) { sim.step(observer); }
