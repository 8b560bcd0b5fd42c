// SPDX-License-Identifier: BSL-1.0
// riprap: friction_angle of a Criterion must be double friction_angle(double minor) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  double major_stress_at_failure(double minor) const { return minor + 300e6; }
  double tensile_strength() const { return 12e6; }
  double friction_angle(double) { return 0.7; }
};

const auto model = Model{}.criterion(Mine{});
