// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What rock is: density, linear elasticity, and its strength over that of the criterion.

#include <riprap/core/errors.hpp>

namespace riprap {

/// Intact rock. The defaults are those of Table 1 of Bagherzadeh-Khalkhali et al. (2008).
/// Strength belongs to the failure criterion, and to triggers that judge by a strength of their
/// own; the factor makes one rock of several stronger or weaker than those say.
struct Rock {
  double young = 70e9;    ///< Young's modulus [Pa]
  double poisson = 0.17;  ///< Poisson's ratio [-], in [0, 0.5)
  double density = 2500;  ///< [kg/m^3]
  /// Loads on a particle are divided by it before criterion and trigger see them [-].
  double strength_factor = 1;

  static void for_each_field(auto& self, auto&& visit) {
    visit("young", self.young);
    visit("poisson", self.poisson);
    visit("density", self.density);
    visit("strength_factor", self.strength_factor);
  }

  /// Throws InvalidInput that names the value and the rule.
  void validate() const {
    require_positive("Rock.young", young);
    require(poisson >= 0 && poisson < 0.5, "Rock.poisson", poisson, "must lie in [0, 0.5)");
    require_positive("Rock.density", density);
    require_positive("Rock.strength_factor", strength_factor);
  }
};

}  // namespace riprap
