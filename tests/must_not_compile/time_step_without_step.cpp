// SPDX-License-Identifier: BSL-1.0
// riprap: a TimeStep must have double time_step(double mass, double stiffness) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  double operator()(double, double) const { return 1e-6; }
  double mass_scaling(double, double) const { return 1; }
};

const auto model = Model{}.time_step(Mine{});
