// SPDX-License-Identifier: BSL-1.0
// riprap: an observer of a LoadingPath or BiaxialTest must have one of the hooks begin_stage,
// progress, record, record_break, stop_requested, end_stage, or one of a step
// (docs/policies/observer.md)
#include <riprap/experiment/biaxial_test.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct Mine {
  void recrod(const auto& /*view*/) {}
};

void run(Simulation<Model<>>& sim, Mine& observer) { BiaxialTest{}.run(sim, observer); }
