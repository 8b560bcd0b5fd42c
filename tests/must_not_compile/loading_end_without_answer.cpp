// SPDX-License-Identifier: BSL-1.0
// riprap: an end condition must be copyable and have bool reached(const auto& view), or be called
// so itself (docs/paths.md)
#include <riprap/experiment/loading_path.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct Mine {
  void reached(const auto& /*view*/) const {}
};

void run(Simulation<Model<>>& sim,
         const LoadingPath<LoadingStage<AxisControl, EndConditionOr<Mine>>>& path) {
  (void)path.run(sim);
}
