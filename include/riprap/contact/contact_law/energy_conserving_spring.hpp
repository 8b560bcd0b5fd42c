// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A normal spring that is the gradient of its energy, through breaks too, with Coulomb slip: the
/// default contact law, with the stiffnesses and the friction of Table 1 of the paper.

#include <algorithm>
#include <cmath>

#include <riprap/contact/contact_law/concepts.hpp>
#include <riprap/contact/contact_law/coulomb_slip.hpp>

namespace riprap {

/// Energy W = k_n (depth - offset)^2 / 2, force k_n (depth - offset) depth_gradient, both zero
/// below the offset; with a narrow phase whose gradient is exact (OverlapMoments) the normal force
/// does no work round a closed path. The tangential spring is that of LinearSpringCoulomb.
///
/// The offset is zero until a particle breaks. The contacts of its pieces with a neighbour then
/// share the force by the areas of their overlaps, with no more energy than before: their offset
/// makes up for it. It falls with the depth while a contact is free of force.
struct EnergyConservingSpring {
  double normal_stiffness = 2e7;      ///< k_n [N/m], of a right-angled corner
  double tangential_stiffness = 2e7;  ///< k_s [N/m]
  double friction = 0.5;              ///< mu [-]

  struct History {
    double tangential_force = 0;  ///< on b along the tangent [N]
    double offset = 0;            ///< depth without force [m]

    static void for_each_field(auto& self, auto&& visit) {
      visit("tangential_force", self.tangential_force);
      visit("offset", self.offset);
    }
  };

  [[nodiscard]] ContactForce operator()(const ContactGeometry& geometry,
                                        const ContactMotion& motion, History& history) const {
    history.offset = std::min(history.offset, geometry.depth);
    ContactForce force{.normal = normal_stiffness * (geometry.depth - history.offset) *
                                 geometry.depth_gradient};
    add_coulomb_slip(force, history.tangential_force, tangential_stiffness, friction, motion);
    return force;
  }

  [[nodiscard]] double stored_energy(const ContactGeometry& geometry,
                                     const History& history) const {
    const double compressed = std::max(0.0, geometry.depth - history.offset);
    return 0.5 * normal_stiffness * compressed * compressed +
           tangential_energy(history.tangential_force, tangential_stiffness);
  }

  /// By area each piece gets its share of the force, but not more than that of the energy.
  [[nodiscard]] History divided_history(const History& history, const ContactGeometry& geometry,
                                        const DividedContact& part) const {
    const double same_force = part.share * geometry.depth_gradient / part.geometry.depth_gradient;
    const double compressed =
        (geometry.depth - history.offset) * std::min(std::sqrt(part.share), same_force);
    return {.tangential_force = part.share * history.tangential_force,
            .offset = std::max(0.0, part.geometry.depth - compressed)};
  }

  /// As much of the bond's force as its energy allows.
  [[nodiscard]] History history_after_bond(const ContactGeometry& geometry,
                                           const FormerBond& bond) const {
    const double compressed =
        std::min(bond.normal_force / (normal_stiffness * geometry.depth_gradient),
                 std::sqrt(2 * bond.normal_energy / normal_stiffness));
    const double most =
        std::min(std::sqrt(2 * tangential_stiffness * bond.tangential_energy),
                 friction * normal_stiffness * compressed * geometry.depth_gradient);
    return {.tangential_force = std::clamp(bond.tangential_force, -most, most),
            .offset = std::max(0.0, geometry.depth - compressed)};
  }

  /// Of two faces, which OverlapMoments gives a spring at both ends.
  [[nodiscard]] double peak_stiffness() const {
    return std::max(2 * normal_stiffness, tangential_stiffness);
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("normal_stiffness", self.normal_stiffness);
    visit("tangential_stiffness", self.tangential_stiffness);
    visit("friction", self.friction);
  }

  void validate() const {
    require_positive("EnergyConservingSpring.normal_stiffness", normal_stiffness);
    validate_coulomb_slip("EnergyConservingSpring", tangential_stiffness, friction);
  }
};

static_assert(ContactLaw<EnergyConservingSpring>);

}  // namespace riprap
