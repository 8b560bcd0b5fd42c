// SPDX-License-Identifier: BSL-1.0
// riprap: a Criterion must have double tensile_strength() const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  double major_stress_at_failure(double minor) const { return minor + 300e6; }
};

const auto model = Model{}.criterion(Mine{});
