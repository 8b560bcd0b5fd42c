// SPDX-License-Identifier: BSL-1.0
// riprap: a TimeStep must have double mass_scaling(double mass, double smallest) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  double time_step(double, double) const { return 1e-6; }
};

const auto model = Model{}.time_step(Mine{});
