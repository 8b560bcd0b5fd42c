// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Curved envelopes through the secant strengths of tests at several stresses.

#include <cmath>
#include <span>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/measurement/regression_line.hpp>
#include <riprap/measurement/secant_strength.hpp>

namespace riprap {

inline constexpr double atmospheric_pressure = 101325;  ///< p_a [Pa]

/// tau / p_a = A (sigma_n / p_a)^b, the power law of de Mello (1977) in dimensionless form. b = 1
/// is a constant friction angle with the tangent A.
struct PowerLawEnvelope {
  double coefficient = 0;                   ///< A [-]
  double exponent = 1;                      ///< b [-]
  double reference = atmospheric_pressure;  ///< p_a [Pa]
  /// Root mean square of ln(tau measured / tau of the envelope): for small ones a share of tau [-].
  double scatter = 0;

  /// Throws InvalidInput unless the stress [Pa] is above 0, as does friction_angle().
  [[nodiscard]] double shear_stress(double normal_stress) const {
    require_positive("normal stress", normal_stress);
    return reference * coefficient * std::pow(normal_stress / reference, exponent);
  }
  /// Secant angle at a normal stress [rad].
  [[nodiscard]] double friction_angle(double normal_stress) const {
    return std::atan(shear_stress(normal_stress) / normal_stress);
  }
};

/// phi = phi_0 - delta_phi log10(sigma_n / reference): the straight lines of Leps (1970) over a
/// logarithmic axis of stress.
struct LogarithmicEnvelope {
  double angle_at_reference = 0;            ///< phi_0 [rad]
  double fall_per_decade = 0;               ///< delta_phi [rad]
  double reference = atmospheric_pressure;  ///< [Pa]
  double scatter = 0;                       ///< root mean square difference from measured phi [rad]

  /// Secant angle at a normal stress [rad]. Throws InvalidInput unless that is above 0 [Pa].
  [[nodiscard]] double friction_angle(double normal_stress) const {
    require_positive("normal stress", normal_stress);
    return angle_at_reference - fall_per_decade * std::log10(normal_stress / reference);
  }
};

/// Least squares of ln tau. Throws InvalidInput for fewer than two different normal stresses and
/// for a strength of 0.
[[nodiscard]] inline PowerLawEnvelope fit_power_law(std::span<const SecantStrength> tests,
                                                    double reference = atmospheric_pressure) {
  require_positive("reference stress", reference);
  std::vector<Vec2> logarithms;
  for (const SecantStrength& t : tests) {
    require_positive("SecantStrength.normal_stress", t.normal_stress);
    require_positive("SecantStrength.shear_stress", t.shear_stress);
    logarithms.push_back(
        {std::log(t.normal_stress / reference), std::log(t.shear_stress / reference)});
  }
  const RegressionLine line = regression_line(logarithms);
  return {std::exp(line.intercept), line.slope, reference, line.scatter};
}

/// Least squares of phi. Throws InvalidInput for fewer than two different normal stresses.
[[nodiscard]] inline LogarithmicEnvelope
fit_logarithmic_law(std::span<const SecantStrength> tests,
                    double reference = atmospheric_pressure) {
  require_positive("reference stress", reference);
  std::vector<Vec2> points;
  for (const SecantStrength& t : tests) {
    require_positive("SecantStrength.normal_stress", t.normal_stress);
    points.push_back({std::log10(t.normal_stress / reference), t.friction_angle});
  }
  const RegressionLine line = regression_line(points);
  return {line.intercept, -line.slope, reference, line.scatter};
}

}  // namespace riprap
