// SPDX-License-Identifier: BSL-1.0
// riprap: an observer has a hook that cannot be called with a const reference to what hooks get
// (docs/policies/observer.md)
#include <riprap/experiment/stage.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct Mine {
  bool stop_requested(BiaxialView<Simulation<Model<>>>&) { return true; }
};

bool ask(Mine& observer, const BiaxialView<Simulation<Model<>>>& view) {
  return hooks::stop_requested(observer, view);
}
