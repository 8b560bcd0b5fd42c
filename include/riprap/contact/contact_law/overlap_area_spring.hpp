// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A contact law whose normal force comes from an energy of the overlap area: exactly conservative.

#include <algorithm>

#include <riprap/contact/contact_law/concepts.hpp>
#include <riprap/contact/contact_law/coulomb_slip.hpp>

namespace riprap {

/// Energy W = area_stiffness * area^2 / 2, force W'(area) * chord = area_stiffness * area * chord
/// along the chord's normal at its middle. Under any rigid motion of the two bodies the area
/// changes by chord times the normal displacement at the middle of the chord (divergence theorem),
/// so the normal force does no net work round a closed path, turns included; LinearSpringCoulomb's
/// does. The tangential spring is that of LinearSpringCoulomb.
struct OverlapAreaSpring {
  double area_stiffness = 6e11;       ///< [N/m^3]; 2 k_n / chord^2 matches k_n at a chord
  double tangential_stiffness = 2e7;  ///< k_s [N/m]
  double friction = 0.5;              ///< mu [-]
  double largest_chord = 0.016;       ///< [m]; with it the time step is chosen

  struct History {
    double tangential_force = 0;  ///< on b along the tangent [N]

    static void for_each_field(auto& self, auto&& visit) {
      visit("tangential_force", self.tangential_force);
    }
  };

  [[nodiscard]] ContactForce operator()(const ContactGeometry& geometry,
                                        const ContactMotion& motion, History& history) const {
    ContactForce force{.normal = area_stiffness * geometry.area * geometry.chord};
    add_coulomb_slip(force, history.tangential_force, tangential_stiffness, friction, motion);
    return force;
  }

  [[nodiscard]] double stored_energy(const ContactGeometry& geometry,
                                     const History& history) const {
    return 0.5 * area_stiffness * geometry.area * geometry.area +
           tangential_energy(history.tangential_force, tangential_stiffness);
  }
  /// Slope of the force for a corner whose chord has grown to the largest one. On a flat face any
  /// convex body has a chord that is concave in the depth, so that area * d chord / d depth is at
  /// most chord^2 / 2; that of a corner is, and that of flat faces is nothing.
  [[nodiscard]] double peak_stiffness() const {
    return std::max(1.5 * area_stiffness * largest_chord * largest_chord, tangential_stiffness);
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("area_stiffness", self.area_stiffness);
    visit("tangential_stiffness", self.tangential_stiffness);
    visit("friction", self.friction);
    visit("largest_chord", self.largest_chord);
  }

  void validate() const {
    require_positive("OverlapAreaSpring.area_stiffness", area_stiffness);
    validate_coulomb_slip("OverlapAreaSpring", tangential_stiffness, friction);
    require_positive("OverlapAreaSpring.largest_chord", largest_chord);
  }
};

static_assert(ContactLaw<OverlapAreaSpring>);

}  // namespace riprap
