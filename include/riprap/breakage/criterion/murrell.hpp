// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Murrell's criterion: Griffith's in three dimensions.

#include <algorithm>
#include <cmath>

#include <riprap/breakage/criterion/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// (s1 - s2)^2 + (s2 - s3)^2 + (s3 - s1)^2 = 24 T (s1 + s2 + s3), a paraboloid that touches the
/// planes s = -T (Murrell 1963), taken at s2 = s3, where triaxial tests measure:
/// sigma_1f = sigma_3 + 6 T (1 + sqrt(1 + sigma_3 / T)). Uniaxial compressive strength 12 T.
struct Murrell {
  double tension = 12e6;  ///< T, tensile strength [Pa]

  [[nodiscard]] double major_stress_at_failure(double minor) const {
    return minor + 6 * tension * (1 + root(minor));
  }
  [[nodiscard]] double tensile_strength() const { return tension; }

  /// From the slope of the curve [rad].
  [[nodiscard]] double friction_angle(double minor) const {
    return std::asin(3 / (3 + 2 * root(minor)));
  }

  static void for_each_field(auto& self, auto&& visit) { visit("tension", self.tension); }

  void validate() const { require_positive("Murrell.tension", tension); }

 private:
  [[nodiscard]] double root(double minor) const {
    return std::sqrt(std::max(0.0, 1 + minor / tension));
  }
};

static_assert(Criterion<Murrell>);

}  // namespace riprap
