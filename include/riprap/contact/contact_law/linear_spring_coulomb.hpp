// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Linear springs with Coulomb slip.

#include <algorithm>

#include <riprap/contact/contact_law/concepts.hpp>
#include <riprap/contact/contact_law/coulomb_slip.hpp>

namespace riprap {

/// F_n = k_n depth depth_gradient, never tension; the tangential spring turns with the normal,
/// grows by k_s du_t and is cut at friction * F_n (Cundall and Strack 1979).
struct LinearSpringCoulomb {
  double normal_stiffness = 2e7;      ///< k_n [N/m], per contact
  double tangential_stiffness = 2e7;  ///< k_s [N/m]
  double friction = 0.5;              ///< mu [-]

  struct History {
    double tangential_force = 0;  ///< on b along the tangent [N]

    static void for_each_field(auto& self, auto&& visit) {
      visit("tangential_force", self.tangential_force);
    }
  };

  [[nodiscard]] ContactForce operator()(const ContactGeometry& geometry,
                                        const ContactMotion& motion, History& history) const {
    ContactForce force{.normal = normal_stiffness * geometry.depth * geometry.depth_gradient};
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
  }

  void validate() const {
    require_positive("LinearSpringCoulomb.normal_stiffness", normal_stiffness);
    validate_coulomb_slip("LinearSpringCoulomb", tangential_stiffness, friction);
  }
};

static_assert(ContactLaw<LinearSpringCoulomb>);

}  // namespace riprap
