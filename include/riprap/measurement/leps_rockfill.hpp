// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Strength of rockfill in large triaxial tests, as collected by Leps (1970).

#include <riprap/core/units.hpp>
#include <riprap/measurement/strength_envelope.hpp>

namespace riprap {

/// The three lines of Leps, T. M. (1970), Review of shearing strength of rockfill, J. Soil Mech.
/// Found. Div. ASCE 96(SM4), 1159-1170: secant friction angle against the logarithm of normal
/// stress. The angles at 1 psi and the falls per decade are straight lines through a table of shear
/// against normal stress from 0.5 to 1000 psi that practice uses for Leps' good, average and poor
/// rockfill; its points lie within 0.4 degrees of them but for one of the low line, which is off by
/// 2 degrees and was left out. The average agrees with the abstract, 55 degrees at very low and 35
/// at high pressure. They were not read from the chart itself: take them as right to 1 degree. The
/// tests scatter about them by several degrees.
struct LepsRockfill {
  static constexpr double psi = 6894.757;  ///< [Pa]
  /// The tests end here [Pa]; the lines beyond are extrapolated.
  static constexpr double lowest_stress = 1 * psi;
  static constexpr double highest_stress = 500 * psi;

  /// Dense, well graded, strong particles.
  [[nodiscard]] static LogarithmicEnvelope high() { return {60.2_deg, 6.8_deg, psi, 0}; }
  [[nodiscard]] static LogarithmicEnvelope average() { return {55.4_deg, 6.9_deg, psi, 0}; }
  /// Loose, poorly graded, weak particles.
  [[nodiscard]] static LogarithmicEnvelope low() { return {50.1_deg, 6.8_deg, psi, 0}; }

  /// Did the tests reach this normal stress [Pa]?
  [[nodiscard]] static bool covers(double normal_stress) {
    return normal_stress >= lowest_stress && normal_stress <= highest_stress;
  }
};

}  // namespace riprap
