// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The Mohr-Coulomb criterion with a tension cut-off.

#include <cmath>

#include <riprap/breakage/criterion/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// sigma_1f = k sigma_3 + 2 c sqrt(k), k = (1 + sin phi) / (1 - sin phi); cut off in tension at
/// `tension`, which may not pass the apex c / tan phi. The defaults are the straight line with the
/// compressive and tensile strengths of Table 1's rock, at its angle of eq. 7 for sigma_3 = 0.
struct MohrCoulomb {
  double cohesion = 32.732684e6;  ///< c [Pa]
  double angle = 1.1410967;       ///< phi [rad]
  double tension = 12e6;          ///< tensile strength [Pa]

  [[nodiscard]] double major_stress_at_failure(double minor) const {
    const double root = slope_root();
    return root * (root * minor + 2 * cohesion);
  }
  [[nodiscard]] double tensile_strength() const { return tension; }
  [[nodiscard]] double friction_angle(double /*minor*/) const { return angle; }

  /// Where the straight line meets sigma_1 = sigma_3 [Pa], positive.
  [[nodiscard]] double apex() const { return cohesion / std::tan(angle); }

  static void for_each_field(auto& self, auto&& visit) {
    visit("cohesion", self.cohesion);
    visit("angle", self.angle);
    visit("tension", self.tension);
  }

  void validate() const {
    require_positive("MohrCoulomb.cohesion", cohesion);
    require(angle > 0 && angle < 1.5, "MohrCoulomb.angle", angle, "must lie in (0, 1.5) rad");
    require_positive("MohrCoulomb.tension", tension);
    require(tension <= apex(), "MohrCoulomb.tension", tension,
            "must not pass the apex cohesion / tan(angle) = " + to_text(apex()) + " Pa");
  }

 private:
  // sqrt(k) = (1 + sin phi) / cos phi
  [[nodiscard]] double slope_root() const { return (1 + std::sin(angle)) / std::cos(angle); }
};

static_assert(Criterion<MohrCoulomb>);

}  // namespace riprap
