// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Linear elastic bonds that fail at once: Mohr-Coulomb with a tension cut-off.

#include <algorithm>
#include <cmath>

#include <riprap/bond/bond_law/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// Tractions k_n opening and k_s sliding, in tension and in compression, linear along the edge, as
/// in the parallel bond of Potyondy and Cundall (2004, A bonded-particle model for rock, Int. J.
/// Rock Mech. Min. Sci. 41). The bond breaks as a whole when the traction at an end of its edge,
/// the extreme fibre, reaches the tensile strength, or its tangential part cohesion + friction *
/// normal pressure. Tension lowers the shear strength by the same line.
///
/// A layer of thickness h of a rock with the modulus E has k_n = E / h; cells of the size h of the
/// same rock, bonded at the ends of a chain, have the modulus k_n h. The default stiffnesses are
/// those of the default contacts, 2e7 N/m, on an edge of 5 mm in plates 16 mm thick.
struct BrittleBond {
  double normal_stiffness = 2.5e11;      ///< k_n [Pa/m]
  double tangential_stiffness = 2.5e11;  ///< k_s [Pa/m]
  double tensile_strength = 10e6;        ///< [Pa]
  double cohesion = 20e6;                ///< [Pa]
  double friction = 0.5;                 ///< tangent of the friction angle [-]

  struct State {
    static void for_each_field(auto&, auto&&) {}
  };

  [[nodiscard]] BondTraction operator()(const BondDisplacement& d, State&) const {
    return {.normal = -normal_stiffness * d.opening,
            .tangential = -tangential_stiffness * d.sliding};
  }
  [[nodiscard]] double stored_energy(const BondDisplacement& d, const State&) const {
    return 0.5 * (normal_stiffness * d.opening * d.opening +
                  tangential_stiffness * d.sliding * d.sliding);
  }
  [[nodiscard]] BondFailure failure(const BondView<State>& bond) const {
    for (const BondDisplacement& end : bond.ends) {
      const double tension = normal_stiffness * end.opening;
      if (tension >= tensile_strength) return BondFailure::tension;
      if (std::abs(tangential_stiffness * end.sliding) >= cohesion - friction * tension)
        return BondFailure::shear;
    }
    return BondFailure::none;
  }
  [[nodiscard]] double peak_stiffness() const {
    return std::max(normal_stiffness, tangential_stiffness);
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("normal_stiffness", self.normal_stiffness);
    visit("tangential_stiffness", self.tangential_stiffness);
    visit("tensile_strength", self.tensile_strength);
    visit("cohesion", self.cohesion);
    visit("friction", self.friction);
  }

  void validate() const {
    require_positive("BrittleBond.normal_stiffness", normal_stiffness);
    require_non_negative("BrittleBond.tangential_stiffness", tangential_stiffness);
    require(tensile_strength > 0, "BrittleBond.tensile_strength", tensile_strength,
            "must be above 0");
    require(cohesion > 0, "BrittleBond.cohesion", cohesion, "must be above 0");
    require_non_negative("BrittleBond.friction", friction);
  }
};

static_assert(BondLaw<BrittleBond>);

}  // namespace riprap
