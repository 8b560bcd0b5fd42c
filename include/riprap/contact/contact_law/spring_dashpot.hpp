// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Linear springs with a normal dashpot and Coulomb slip.

#include <algorithm>
#include <cmath>

#include <riprap/contact/contact_law/concepts.hpp>
#include <riprap/contact/contact_law/coulomb_slip.hpp>

namespace riprap {

/// F_n = k_n depth g - c v_n g^2, g the gradient of the depth, with c = 2 zeta sqrt(k_n m_eff); the
/// tangential spring is that of LinearSpringCoulomb. Two variants are in use and differ by up to
/// 0.14 in the restitution: the force may pull at the end of a collision, e = exp(-pi zeta / sqrt(1
/// - zeta^2)), or is clamped at zero, e = exp(-zeta / sqrt(1 - zeta^2) atan2(2 zeta sqrt(1 -
/// zeta^2), 2 zeta^2 - 1)) (Schwager and Poeschel 2007).
struct SpringDashpot {
  double normal_stiffness = 2e7;      ///< k_n [N/m]
  double tangential_stiffness = 2e7;  ///< k_s [N/m]
  double friction = 0.5;              ///< mu [-]
  double damping_ratio = 0.2;         ///< zeta [-], in [0, 1)
  bool may_pull = false;              ///< false: clamped, never tension

  struct History {
    double tangential_force = 0;  ///< on b along the tangent [N]

    static void for_each_field(auto& self, auto&& visit) {
      visit("tangential_force", self.tangential_force);
    }
  };

  [[nodiscard]] ContactForce operator()(const ContactGeometry& geometry,
                                        const ContactMotion& motion, History& history) const {
    const double spring = normal_stiffness * geometry.depth * geometry.depth_gradient;
    const double viscosity =
        2 * damping_ratio * std::sqrt(normal_stiffness * motion.effective_mass);
    const double depth_rate = geometry.depth_gradient * motion.normal_velocity;
    ContactForce force{.normal = spring - viscosity * geometry.depth_gradient * depth_rate};
    if (!may_pull) force.normal = std::max(force.normal, 0.0);
    force.viscous_loss = (spring - force.normal) * motion.normal_velocity * motion.time_step;
    add_coulomb_slip(force, history.tangential_force, tangential_stiffness, friction, motion);
    return force;
  }

  [[nodiscard]] double stored_energy(const ContactGeometry& geometry,
                                     const History& history) const {
    return 0.5 * normal_stiffness * geometry.depth * geometry.depth +
           tangential_energy(history.tangential_force, tangential_stiffness);
  }
  [[nodiscard]] double peak_stiffness() const {
    return std::max(normal_stiffness, tangential_stiffness);
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("normal_stiffness", self.normal_stiffness);
    visit("tangential_stiffness", self.tangential_stiffness);
    visit("friction", self.friction);
    visit("damping_ratio", self.damping_ratio);
    visit("may_pull", self.may_pull);
  }

  void validate() const {
    require_positive("SpringDashpot.normal_stiffness", normal_stiffness);
    validate_coulomb_slip("SpringDashpot", tangential_stiffness, friction);
    require(damping_ratio >= 0 && damping_ratio < 1, "SpringDashpot.damping_ratio", damping_ratio,
            "must lie in [0, 1)");
  }
};

static_assert(ContactLaw<SpringDashpot>);

}  // namespace riprap
