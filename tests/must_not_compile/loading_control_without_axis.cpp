// SPDX-License-Identifier: BSL-1.0
// riprap: the control of an axis must be copyable and have double rate(const auto& view, int axis),
// or the same with a third argument double other (docs/paths.md)
#include <riprap/experiment/loading_path.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct Mine {
  double rate(const auto& /*view*/) const { return 0; }
};

void run(Simulation<Model<>>& sim, const LoadingPath<LoadingStage<AxisControlOr<Mine>>>& path) {
  (void)path.run(sim);
}
