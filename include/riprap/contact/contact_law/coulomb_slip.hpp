// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A tangential spring cut by Coulomb friction: the part that contact laws have in common.

#include <algorithm>
#include <cmath>
#include <string>

#include <riprap/contact/contact_law/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// Tangential force after a step, and the energy that slip has taken.
struct CoulombSlip {
  double force = 0;          ///< [N]
  double friction_loss = 0;  ///< [J], >= 0
};

/// The spring grows by -stiffness * velocity * time and is cut at +-cap (Cundall and Strack 1979).
/// What the spring does not take up is slip, against the mean force of the step.
/// @param before force before the step [N]; @param cap friction times normal force [N], >= 0
[[nodiscard]] inline CoulombSlip coulomb_slip(double before, double stiffness, double velocity,
                                              double time_step, double cap) {
  const double trial = before - stiffness * velocity * time_step;
  CoulombSlip result{.force = std::clamp(trial, -cap, cap)};
  // Most contacts stick: they avoid the division.
  if (stiffness > 0 && std::abs(trial) > cap)
    result.friction_loss =
        std::abs(0.5 * (before + result.force) * (trial - result.force)) / stiffness;
  return result;
}

/// Throws InvalidInput for parameters of `law` that are not finite numbers, 0 or above.
inline void validate_coulomb_slip(const std::string& law, double tangential_stiffness,
                                  double friction) {
  require_non_negative(law + ".tangential_stiffness", tangential_stiffness);
  require_non_negative(law + ".friction", friction);
}

/// Fills in the tangential half of a contact force.
/// @param spring the tangential force kept in the history [N]; brought up to date
inline void add_coulomb_slip(ContactForce& force, double& spring, double stiffness, double friction,
                             const ContactMotion& motion) {
  const CoulombSlip slip = coulomb_slip(spring, stiffness, motion.tangential_velocity,
                                        motion.time_step, friction * std::max(force.normal, 0.0));
  force.tangential = spring = slip.force;
  force.friction_loss = slip.friction_loss;
}

/// Energy stored in the spring [J].
[[nodiscard]] inline double tangential_energy(double force, double stiffness) {
  return stiffness > 0 ? 0.5 * force * force / stiffness : 0;
}

}  // namespace riprap
