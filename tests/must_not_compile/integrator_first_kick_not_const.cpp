// SPDX-License-Identifier: BSL-1.0
// riprap: an Integrator's first_kick_fraction must be double first_kick_fraction() const
#include <riprap/dynamics/integrator/velocity_verlet.hpp>
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine : VelocityVerlet {
  double first_kick_fraction() { return 0.5; }
};

const auto model = Model{}.integrator(Mine{});
