// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Franklin's criterion: a power of the sum of the principal stresses.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <riprap/breakage/criterion/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// sigma_1 - sigma_3 = sigma_c^(1 - B) (sigma_1 + sigma_3)^B (Franklin 1971), cut off in tension at
/// `tension`, which may not pass the end of the curve. With B = 0.5 it is Griffith's parabola,
/// sigma_c = 8 T. The default B is the largest, to one digit, that leaves room for the tensile
/// strength of Table 1's rock.
struct Franklin {
  double compressive_strength = 300e6;  ///< sigma_c, uniaxial [Pa]
  double exponent = 0.8;                ///< B [-]
  double tension = 12e6;                ///< tensile strength [Pa]

  [[nodiscard]] double major_stress_at_failure(double minor) const {
    if (minor < -tension) return minor;
    return minor + compressive_strength * difference(minor / compressive_strength);
  }
  [[nodiscard]] double tensile_strength() const { return tension; }

  /// From the slope of the curve [rad]: sin phi = B (sigma_1 - sigma_3) / (sigma_1 + sigma_3), that
  /// is B times the ratio at failure. 90 degrees beyond the tensile strength.
  [[nodiscard]] double friction_angle(double minor) const {
    if (minor < -tension) return 0.5 * std::numbers::pi;
    const double scaled = minor / compressive_strength;
    const double d = difference(scaled);
    return std::asin(std::min(1.0, exponent * d / (d + 2 * scaled)));
  }

  /// Where the curve ends, with a vertical tangent: -sigma_3 [Pa].
  [[nodiscard]] double end() const {
    return 0.5 * compressive_strength * (1 - exponent) *
           std::pow(exponent, exponent / (1 - exponent));
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("compressive_strength", self.compressive_strength);
    visit("exponent", self.exponent);
    visit("tension", self.tension);
  }

  void validate() const {
    require_positive("Franklin.compressive_strength", compressive_strength);
    require(exponent >= 0.5 && exponent < 1, "Franklin.exponent", exponent, "must lie in [0.5, 1)");
    require_positive("Franklin.tension", tension);
    require(tension <= end(), "Franklin.tension", tension,
            "must not pass the end of the curve, " + to_text(end()) + " Pa");
  }

 private:
  // The larger solution d = (sigma_1 - sigma_3) / sigma_c of d^(1/B) - d = 2 sigma_3 / sigma_c, by
  // Halley's method: two steps at most stresses. The first guess has value, slope and curvature
  // right at d = 1; the left side is convex and, with B >= 0.5, ever less so.
  [[nodiscard]] double difference(double scaled) const {
    const double b = exponent;
    const double inverse = 1 / b;
    const double under_root = 1 + 4 * scaled / (1 - b);
    double d = 1 - b + b * std::sqrt(std::max(0.0, under_root));
    for (int i = 0; i < 64; ++i) {
      const double power = std::pow(d, inverse - 1);
      const double slope = inverse * power - 1;
      if (!(slope > 0)) break;  // round-off at the end of the curve
      const double excess = d * (power - 1) - 2 * scaled;
      const double half_curvature_d = 0.5 * inverse * (inverse - 1) * power;  // times d
      const double step = excess * slope * d / (slope * slope * d - excess * half_curvature_d);
      d -= step;
      // The next step would be of the order of this one cubed: round-off.
      if (std::abs(step) <= 3e-6 * d) break;
    }
    return d;
  }
};

static_assert(Criterion<Franklin>);

}  // namespace riprap
