// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The Hoek-Brown criterion: the default.

#include <cmath>
#include <numbers>

#include <riprap/breakage/criterion/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// sigma_1f = sigma_3 + sigma_c (m_b sigma_3 / sigma_c + S)^a_b, tensile strength S sigma_c / m_b
/// (Hoek and Brown 1980, 1997; eq. 1 of the paper with S put back). Defaults: Table 1.
struct HoekBrown {
  /// Where the friction angle comes from.
  enum class Angle {
    equivalent,  ///< the Mohr-Coulomb fit of Hoek (2002), applied at a point: eq. 7 of the paper
    tangent,     ///< the true slope of the curve, some 5 to 8 degrees lower
  };

  double compressive_strength = 300e6;  ///< sigma_c, uniaxial [Pa]
  double m_b = 25;                      ///< [-]
  double s = 1;                         ///< S [-], 1 for intact rock
  double a_b = 0.5;                     ///< [-], 0.5 for intact rock
  Angle angle = Angle::equivalent;

  [[nodiscard]] double major_stress_at_failure(double minor) const {
    const double x = scaled(minor);
    if (x <= 0) return minor;
    return minor + compressive_strength * (a_b == 0.5 ? std::sqrt(x) : std::pow(x, a_b));
  }
  [[nodiscard]] double tensile_strength() const { return s * compressive_strength / m_b; }

  /// Eq. 7, with sigma_3 divided by sigma_c as it must be, or the tangent. 90 degrees at and beyond
  /// the tensile strength.
  [[nodiscard]] double friction_angle(double minor) const {
    const double x = scaled(minor);
    if (x <= 0) return 0.5 * std::numbers::pi;
    const double slope = a_b * m_b * std::pow(x, a_b - 1);
    if (angle == Angle::tangent) return friction_angle_from_slope(1 + slope);
    return std::asin(6 * slope / (2 * (1 + a_b) * (2 + a_b) + 6 * slope));
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("compressive_strength", self.compressive_strength);
    visit("m_b", self.m_b);
    visit("s", self.s);
    visit("a_b", self.a_b);
    visit("angle", self.angle);
  }

  void validate() const {
    require_positive("HoekBrown.compressive_strength", compressive_strength);
    require_positive("HoekBrown.m_b", m_b);
    require(s > 0 && s <= 1, "HoekBrown.s", s, "must lie in (0, 1]");
    require(a_b > 0 && a_b <= 1, "HoekBrown.a_b", a_b, "must lie in (0, 1]");
  }

 private:
  [[nodiscard]] double scaled(double minor) const { return m_b * minor / compressive_strength + s; }
};

static_assert(Criterion<HoekBrown>);

}  // namespace riprap
