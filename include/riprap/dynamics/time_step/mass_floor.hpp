// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Constant time step from the smallest intact particle; lighter pieces move as if they had its
/// mass. The default.

#include <cmath>

#include <riprap/core/errors.hpp>
#include <riprap/dynamics/time_step/concepts.hpp>

namespace riprap {

/// dt = fraction * sqrt(m / k). At 0.12 sharp samples come to rest and the answer in shear no
/// longer depends on the step; at 0.5 it runs and the answer is wrong.
struct MassFloor {
  double fraction = 0.12;  ///< of sqrt(m / k) [-]

  [[nodiscard]] double time_step(double mass, double stiffness) const {
    return fraction * std::sqrt(mass / stiffness);
  }
  [[nodiscard]] double mass_scaling(double mass, double smallest) const {
    return mass < smallest ? smallest / mass : 1;
  }
  void validate() const { require_positive("MassFloor.fraction", fraction); }
};

static_assert(TimeStep<MassFloor>);

}  // namespace riprap
