// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Normal and tangential springs that grow with the displacement since the contact began.

#include <algorithm>

#include <riprap/contact/contact_law/concepts.hpp>
#include <riprap/contact/contact_law/coulomb_slip.hpp>

namespace riprap {

/// F_n grows by -k_n du_n in every step and is cut at zero; the tangential spring is that of
/// LinearSpringCoulomb (program BALL: Cundall and Strack 1979). The depth is not used, so that the
/// spring gives back what it took whatever the narrow phase; but force and depth part: an overlap
/// may remain without force, and a new contact of a piece starts without force at any depth. For
/// narrow phases whose contact point stays in the overlap: OverlapChord, SeparatingAxis.
struct IncrementalSpring {
  double normal_stiffness = 2e7;      ///< k_n [N/m]
  double tangential_stiffness = 2e7;  ///< k_s [N/m]
  double friction = 0.5;              ///< mu [-]

  struct History {
    double normal_force = 0;      ///< [N], >= 0
    double tangential_force = 0;  ///< on b along the tangent [N]

    static void for_each_field(auto& self, auto&& visit) {
      visit("normal_force", self.normal_force);
      visit("tangential_force", self.tangential_force);
    }
  };

  [[nodiscard]] ContactForce operator()(const ContactGeometry&, const ContactMotion& motion,
                                        History& history) const {
    history.normal_force = std::max(
        0.0, history.normal_force - normal_stiffness * motion.normal_velocity * motion.time_step);
    ContactForce force{.normal = history.normal_force};
    add_coulomb_slip(force, history.tangential_force, tangential_stiffness, friction, motion);
    return force;
  }

  [[nodiscard]] double stored_energy(const ContactGeometry&, const History& history) const {
    return 0.5 * history.normal_force * history.normal_force / normal_stiffness +
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
    require_positive("IncrementalSpring.normal_stiffness", normal_stiffness);
    validate_coulomb_slip("IncrementalSpring", tangential_stiffness, friction);
  }
};

static_assert(ContactLaw<IncrementalSpring>);

}  // namespace riprap
