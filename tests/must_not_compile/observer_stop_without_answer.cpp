// SPDX-License-Identifier: BSL-1.0
// riprap: stop_requested of an observer must give back a bool
#include <riprap/experiment/stage.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct Mine {
  void stop_requested(const BiaxialView<Simulation<Model<>>>&) {}
};

bool ask(Mine& observer, const BiaxialView<Simulation<Model<>>>& view) {
  return hooks::stop_requested(observer, view);
}
