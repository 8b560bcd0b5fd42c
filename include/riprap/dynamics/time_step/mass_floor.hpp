// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Constant time step from the smallest intact particle; lighter pieces move as if they had its
/// mass. The default.

#include <cmath>

#include <riprap/core/errors.hpp>
#include <riprap/dynamics/time_step/concepts.hpp>

namespace riprap {

/// dt = fraction * sqrt(m / k), with k the contact law's peak stiffness. See
/// docs/theory/time_step.md for what the fraction changes; 0.12 is for laws that make energy, as
/// LinearSpringCoulomb.
struct MassFloor {
  double fraction = 0.24;  ///< of sqrt(m / k) [-]

  [[nodiscard]] double time_step(double mass, double stiffness) const {
    return fraction * std::sqrt(mass / stiffness);
  }
  [[nodiscard]] double mass_scaling(double mass, double smallest) const {
    return mass < smallest ? smallest / mass : 1;
  }

  static void for_each_field(auto& self, auto&& visit) { visit("fraction", self.fraction); }

  void validate() const { require_positive("MassFloor.fraction", fraction); }
};

static_assert(TimeStep<MassFloor>);

}  // namespace riprap
