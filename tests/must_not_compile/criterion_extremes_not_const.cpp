// SPDX-License-Identifier: BSL-1.0
// riprap: extreme_stresses of a Criterion must be PrincipalValues
// extreme_stresses(const PrincipalValues& in_plane) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  double major_stress_at_failure(double minor) const { return minor + 300e6; }
  double tensile_strength() const { return 12e6; }
  PrincipalValues extreme_stresses(const PrincipalValues& in_plane) { return in_plane; }
};

const auto model = Model{}.criterion(Mine{});
