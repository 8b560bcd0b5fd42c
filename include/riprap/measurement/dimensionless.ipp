// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <limits>

#include <riprap/measurement/dimensionless.hpp>

namespace riprap {

RIPRAP_INLINE double inertial_number(double strain_rate, double diameter, double density,
                                     double pressure) {
  if (!(pressure > 0)) return std::numeric_limits<double>::infinity();
  return strain_rate * diameter * std::sqrt(density / pressure);
}

RIPRAP_INLINE double stiffness_level(double pressure, double thickness, double normal_stiffness) {
  return pressure * thickness / normal_stiffness;
}

RIPRAP_INLINE double time_step_ratio(double time_step, const Particles& particles,
                                     double stiffness) {
  double lightest = std::numeric_limits<double>::infinity();
  for (const Body& body : particles.bodies())
    if (body.is_free()) lightest = std::min(lightest, body.mass_scaling * body.mass);
  return time_step / std::sqrt(lightest / stiffness);
}

}  // namespace riprap
