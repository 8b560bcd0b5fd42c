// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Strength of rockfill from the properties of its stones: Barton and Kjaernsli (1981).

#include <cmath>
#include <numbers>

#include <riprap/core/errors.hpp>

namespace riprap {

/// phi = R log10(S / sigma_n) + phi_b, with R in degrees: Barton, N. and Kjaernsli, B. (1981),
/// Shear strength of rockfill, J. Geotech. Eng. Div. ASCE 107(GT7), 873-891. The friction of a flat
/// face of the rock, and above it what interlocking adds until the stones crush.
struct BartonKjaernsli {
  /// R, by their chart from porosity and the roundness and smoothness of the stones: about 0 for
  /// loose rounded gravel to 15 for dense quarried rock [degrees per decade of stress].
  double equivalent_roughness = 0;
  /// S, by their chart a share of the rock's uniaxial compressive strength that falls with the
  /// median size of the stones, and is another one in plane strain than in triaxial tests [Pa].
  double equivalent_strength = 0;
  /// phi_b, of sawn or sand-blasted faces, commonly 25 to 35 degrees [rad].
  double basic_friction_angle = 0;

  void validate() const {
    require_non_negative("BartonKjaernsli.equivalent_roughness", equivalent_roughness);
    require_positive("BartonKjaernsli.equivalent_strength", equivalent_strength);
    require(basic_friction_angle > 0 && basic_friction_angle < 0.5 * std::numbers::pi,
            "BartonKjaernsli.basic_friction_angle", basic_friction_angle,
            "must lie in (0, pi/2) radians");
  }

  /// Secant angle at a normal stress [rad]. Throws InvalidInput unless this lies above 0 and below
  /// S, from where on the stones no longer interlock and the law does not hold, and if the angle
  /// would reach 90 degrees, as it does towards no stress at all.
  [[nodiscard]] double friction_angle(double normal_stress) const {
    validate();
    require(normal_stress > 0 && normal_stress < equivalent_strength, "normal stress",
            normal_stress, "must lie above 0 and below the equivalent strength");
    const double angle = basic_friction_angle + equivalent_roughness * std::numbers::pi / 180 *
                                                    std::log10(equivalent_strength / normal_stress);
    require(angle < 0.5 * std::numbers::pi, "normal stress", normal_stress,
            "is too low for this law: its friction angle is 90 degrees or more");
    return angle;
  }
  /// Shear strength at a normal stress [Pa]; throws as friction_angle().
  [[nodiscard]] double shear_stress(double normal_stress) const {
    return normal_stress * std::tan(friction_angle(normal_stress));
  }
};

}  // namespace riprap
