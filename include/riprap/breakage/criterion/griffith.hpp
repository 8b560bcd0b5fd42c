// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Griffith's criterion: open cracks of every direction in a plane.

#include <algorithm>
#include <cmath>

#include <riprap/breakage/criterion/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// (sigma_1 - sigma_3)^2 = 8 T (sigma_1 + sigma_3) where sigma_1 + 3 sigma_3 > 0, else
/// sigma_3 = -T (Griffith 1924, in a plane). The uniaxial compressive strength is 8 T: Griffith's
/// rock has one strength, not two.
struct Griffith {
  double tension = 12e6;  ///< T, tensile strength [Pa]

  [[nodiscard]] double major_stress_at_failure(double minor) const {
    return minor + 4 * tension * (1 + root(minor));
  }
  [[nodiscard]] double tensile_strength() const { return tension; }

  /// [rad] The shear planes are the cracks that grow: at psi to the major direction,
  /// cos 2 psi = sin phi = (sigma_1 - sigma_3) / (2 (sigma_1 + sigma_3)).
  [[nodiscard]] double friction_angle(double minor) const {
    return std::asin(1 / (1 + root(minor)));
  }

  static void for_each_field(auto& self, auto&& visit) { visit("tension", self.tension); }

  void validate() const { require_positive("Griffith.tension", tension); }

 private:
  [[nodiscard]] double root(double minor) const {
    return std::sqrt(std::max(0.0, 1 + minor / tension));
  }
};

static_assert(Criterion<Griffith>);

}  // namespace riprap
