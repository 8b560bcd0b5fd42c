// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What rock is, apart from its strength: density and linear elasticity.

#include <riprap/core/errors.hpp>

namespace riprap {

/// Intact rock. The defaults are those of Table 1 of Bagherzadeh-Khalkhali et al. (2008).
/// Strength belongs to the failure criterion.
struct Rock {
  double young = 70e9;    ///< Young's modulus [Pa]
  double poisson = 0.17;  ///< Poisson's ratio [-], in [0, 0.5)
  double density = 2500;  ///< [kg/m^3]

  static void for_each_field(auto& self, auto&& visit) {
    visit("young", self.young);
    visit("poisson", self.poisson);
    visit("density", self.density);
  }

  /// Throws InvalidInput that names the value and the rule.
  void validate() const {
    require_positive("Rock.young", young);
    require(poisson >= 0 && poisson < 0.5, "Rock.poisson", poisson, "must lie in [0, 0.5)");
    require_positive("Rock.density", density);
  }
};

}  // namespace riprap
