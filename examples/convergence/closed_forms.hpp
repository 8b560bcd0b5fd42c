// SPDX-License-Identifier: BSL-1.0
#pragma once
// Two bodies whose critical loads have closed forms.

#include "loaded_particle.hpp"

namespace convergence {

// A body under a unit load, and the load at which 0.4 of its area has failed, by HoekBrown{}.
struct KnownStrength {
  Sample body;
  double load = 0;
};

// A disc of 16 mm, as a regular polygon of 64 sides, between two opposite forces of 1 N. Two fields
// of Flamant and a uniform tension (Timoshenko and Goodier, Theory of Elasticity), integrated.
[[nodiscard]] KnownStrength disc_between_forces();

// A bar of 48 mm by 16 mm bent by moments of 1 N m: stress grows linearly from the axis to both
// edges. Tension fails first: (1 - sigma_t / sigma) / 2 of the area, with sigma at the edge.
[[nodiscard]] KnownStrength bent_bar();

}  // namespace convergence
