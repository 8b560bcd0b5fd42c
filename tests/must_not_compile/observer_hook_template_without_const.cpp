// SPDX-License-Identifier: BSL-1.0
// riprap: an observer has a hook that cannot be called with a const reference to what hooks get
// (docs/policies/observer.md)
#include <riprap/experiment/stage.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct Mine {
  template <class Sim>
  void record(BiaxialView<Sim>&) {}
};

void tell(Mine& observer, const BiaxialView<Simulation<Model<>>>& view) {
  hooks::record(observer, view);
}
