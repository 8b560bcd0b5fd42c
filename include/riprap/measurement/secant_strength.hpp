// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Strength of one test as those who build with rock quote it: the secant friction angle and the
/// normal stress that belongs to it.

#include <cmath>

#include <riprap/core/errors.hpp>

namespace riprap {

/// The point where a line through the origin touches the Mohr circle of a test; no cohesion.
/// Stresses are effective ones, compression positive.
struct SecantStrength {
  double friction_angle = 0;  ///< phi = atan(shear_stress / normal_stress) [rad]
  double normal_stress = 0;   ///< sigma_n on the plane that the line means [Pa]
  double shear_stress = 0;    ///< tau on that plane [Pa]
};

/// From sin phi = (sigma_1 - sigma_3)/(sigma_1 + sigma_3), eq. 12 of the paper, and the minor
/// stress. The circle has its centre at c = sigma_3 / (1 - sin phi) and the radius c sin phi; the
/// line touches it at sigma_n = c cos^2 phi = sigma_3 (1 + sin phi), where tau = sigma_n tan phi.
/// Throws InvalidInput for sin phi outside [0, 1).
/// @param minor_stress sigma_3 [Pa], above 0
[[nodiscard]] inline SecantStrength secant_strength(double sin_phi, double minor_stress) {
  require(sin_phi >= 0 && sin_phi < 1, "sin phi", sin_phi, "must lie in [0, 1)");
  require_positive("minor stress", minor_stress);
  const double normal = minor_stress * (1 + sin_phi);
  const double tangent = sin_phi / std::sqrt((1 - sin_phi) * (1 + sin_phi));
  return {std::asin(sin_phi), normal, normal * tangent};
}

}  // namespace riprap
