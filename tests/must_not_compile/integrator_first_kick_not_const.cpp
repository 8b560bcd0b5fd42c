// SPDX-License-Identifier: BSL-1.0
// riprap: an Integrator's first_kick must be double first_kick() const
#include <riprap/dynamics/integrator/velocity_verlet.hpp>
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine : VelocityVerlet {
  double first_kick() { return 0.5; }
};

const auto model = Model{}.integrator(Mine{});
