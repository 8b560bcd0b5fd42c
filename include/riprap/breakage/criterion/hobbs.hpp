// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Hobbs's criterion: a power of the confining stress.

#include <cmath>

#include <riprap/breakage/criterion/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// sigma_1f = sigma_3 + sigma_c + F sigma_3^n (Hobbs 1964), with F = factor sigma_c^(1 - n) so that
/// the parameters have no odd units. The power ends at sigma_3 = 0: in tension the curve is the
/// straight line to the tensile strength, sigma_c (1 + sigma_3 / T), which is riprap's addition.
/// The defaults have the strengths of Table 1's rock and are within 19 MPa of its Hoek-Brown curve
/// for sigma_3 from 0 to sigma_c / 2 (least squares, rounded).
struct Hobbs {
  double compressive_strength = 300e6;  ///< sigma_c, uniaxial [Pa]
  double factor = 4.4;                  ///< [-]
  double exponent = 0.7;                ///< n [-]
  double tension = 12e6;                ///< T, tensile strength [Pa]

  [[nodiscard]] double major_stress_at_failure(double minor) const {
    if (minor <= 0) return compressive_strength * (1 + minor / tension);
    const double power = std::pow(minor / compressive_strength, exponent);
    return minor + compressive_strength * (1 + factor * power);
  }
  [[nodiscard]] double tensile_strength() const { return tension; }

  /// From the slope of the curve [rad]: infinite just above sigma_3 = 0, where the planes are
  /// parallel to the major stress.
  [[nodiscard]] double friction_angle(double minor) const {
    if (minor <= 0) return friction_angle_from_slope(compressive_strength / tension);
    // 2 / (k - 1), which is finite where the slope k is not.
    const double flatness =
        2 * std::pow(minor / compressive_strength, 1 - exponent) / (factor * exponent);
    return std::asin(1 / (1 + flatness));
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("compressive_strength", self.compressive_strength);
    visit("factor", self.factor);
    visit("exponent", self.exponent);
    visit("tension", self.tension);
  }

  void validate() const {
    require_positive("Hobbs.compressive_strength", compressive_strength);
    require_positive("Hobbs.factor", factor);
    require(exponent > 0 && exponent <= 1, "Hobbs.exponent", exponent, "must lie in (0, 1]");
    require_positive("Hobbs.tension", tension);
    require(tension <= compressive_strength, "Hobbs.tension", tension,
            "must not exceed the compressive strength");
  }
};

static_assert(Criterion<Hobbs>);

}  // namespace riprap
