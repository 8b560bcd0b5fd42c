// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The Hoek-Brown criterion of a rock mass, from its Geological Strength Index.

#include <cmath>

#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// Field observations of a rock mass (Hoek, Carranza-Torres and Corkum 2002). The defaults are
/// Table 1's rock, intact.
struct RockMass {
  double compressive_strength = 300e6;  ///< sigma_ci of the intact rock, uniaxial [Pa]
  double m_i = 25;                      ///< of the intact rock [-]
  double gsi = 100;                     ///< Geological Strength Index [-], 100: no joints
  double disturbance = 0;               ///< D, from blasting and unloading [-], 0: none, 1: most

  /// m_b = m_i exp((GSI - 100) / (28 - 14 D)), S = exp((GSI - 100) / (9 - 3 D)),
  /// a_b = 1/2 + (exp(-GSI / 15) - exp(-20 / 3)) / 6.
  /// @throws InvalidInput for parameters that break a rule
  [[nodiscard]] HoekBrown hoek_brown() const {
    validate();
    return {.compressive_strength = compressive_strength,
            .m_b = m_i * std::exp((gsi - 100) / (28 - 14 * disturbance)),
            .s = std::exp((gsi - 100) / (9 - 3 * disturbance)),
            .a_b = 0.5 + (std::exp(-gsi / 15) - std::exp(-20.0 / 3)) / 6};
  }

  void validate() const {
    require_positive("RockMass.compressive_strength", compressive_strength);
    require_positive("RockMass.m_i", m_i);
    require(gsi >= 0 && gsi <= 100, "RockMass.gsi", gsi, "must lie in [0, 100]");
    require(disturbance >= 0 && disturbance <= 1, "RockMass.disturbance", disturbance,
            "must lie in [0, 1]");
  }
};

}  // namespace riprap
