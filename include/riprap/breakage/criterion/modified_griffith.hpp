// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Griffith's criterion for cracks that close under pressure and rub.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <riprap/breakage/criterion/concepts.hpp>
#include <riprap/breakage/criterion/griffith.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// Open cracks grow as Griffith has it; those that are pressed shut have to slide:
/// sigma_1 (w - f) - sigma_3 (w + f) = 4 T, w^2 = 1 + f^2 (McClintock and Walsh 1962, for cracks
/// that close without pressure). In Mohr's plane these are tau^2 = 4 T (T + sigma) for sigma <= 0
/// and tau = 2 T + f sigma for sigma >= 0, and the rock fails by what is reached first. The
/// uniaxial compressive strength is 4 T (w + f).
struct ModifiedGriffith {
  double tension = 12e6;  ///< T, tensile strength [Pa]
  double friction = 1;    ///< f, between the faces of a crack [-]; at 1 line and parabola touch

  [[nodiscard]] double major_stress_at_failure(double minor) const {
    const double sliding = sliding_limit(minor);
    return open(minor) ? std::min(opening_limit(minor), sliding) : sliding;
  }
  [[nodiscard]] double tensile_strength() const { return tension; }

  /// Slope of Mohr's envelope where it is reached [rad].
  [[nodiscard]] double friction_angle(double minor) const {
    if (open(minor) && opening_limit(minor) < sliding_limit(minor))
      return Griffith{tension}.friction_angle(minor);
    return std::atan(friction);
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("tension", self.tension);
    visit("friction", self.friction);
  }

  void validate() const {
    require_positive("ModifiedGriffith.tension", tension);
    require(friction > 0 && friction <= 1, "ModifiedGriffith.friction", friction,
            "must lie in (0, 1]: closed cracks may not be stronger than open ones");
  }

 private:
  // Is there tension across the crack that opens first? The parabola is touched at sigma <= 0.
  [[nodiscard]] bool open(double minor) const {
    return (1 + std::numbers::sqrt2) * minor <= -2 * tension;
  }
  [[nodiscard]] double opening_limit(double minor) const {
    return Griffith{tension}.major_stress_at_failure(minor);
  }
  [[nodiscard]] double sliding_limit(double minor) const {
    const double root = friction + std::sqrt(1 + friction * friction);
    return root * (root * minor + 4 * tension);
  }
};

static_assert(Criterion<ModifiedGriffith>);

}  // namespace riprap
