// SPDX-License-Identifier: BSL-1.0
// Section 4.4: mobilised friction, and its relation to the anisotropies.

#include <cmath>
#include <numeric>

#include "../results/curve_features.hpp"
#include "claims.hpp"

namespace report {

namespace {

double peak_friction(const Run& run) { return smooth_peak(run, "sin_phi").value; }
double gap_of_eq_14(const Run& run) { return mean_gap(run, "sin_phi_eq_14"); }
double gap_of_eq_15(const Run& run) { return mean_gap(run, "sin_phi_eq_15"); }

// Fall of the peak with each doubling of the pressure, from 4 to 14 MPa, less that from 0.5 to
// 4 MPa, sample by sample.
Evidence steeper_at_high_pressure(const Results& results, Mode mode) {
  const std::vector<double> high = paired(results, mode, 4e6, mode, 14e6, peak_friction);
  const std::vector<double> low = paired(results, mode, 0.5e6, mode, 4e6, peak_friction);
  if (high.size() != low.size() || high.size() < 2)
    return {{}, {to_text(mode) + ": two samples at 0.5, 4 and 14 MPa"}};
  std::vector<double> differences;
  for (std::size_t i = 0; i < high.size(); ++i)
    differences.push_back(high[i] / std::log2(14.0 / 4.0) - low[i] / std::log2(4.0 / 0.5));
  const Estimate difference = estimate(differences);
  return {{{to_text(mode), "", difference, outcome_above_zero(difference)}}, {}};
}

Claim friction_falls(const Results& results, Mode breakable) {
  return judged(
      {.id = "friction_falls_with_pressure",
       .section = "4.4, 5",
       .figures = {19},
       .text = "Confining pressure lowers the angle of internal friction, with and without "
               "breakage.",
       .rule =
           "the largest sin phi, averaged over 2 % of strain, falls from 0.5 to 14 MPa, without "
           "a step that clearly rises",
       .quantity = "change of the largest sin phi",
       .if_holds =
           "Without breakage the rock's strength does not enter: what pressure changes there "
           "is kappa, pressure times thickness over stiffness."},
      trend_with_pressure(results, {Mode::nb, breakable}, peak_friction, Claimed::below));
}

Claim fails_at_higher_stress(const Results& results, Mode breakable) {
  const std::vector<Mode> both{Mode::nb, breakable};
  Evidence evidence =
      trend_with_pressure(
          results, both, [](const Run& run) { return 1e-6 * largest(run, "sigma_22_Pa"); },
          Claimed::above)
          .labelled("axial stress [MPa]");
  Evidence strain =
      trend_with_pressure(
          results, both, [](const Run& run) { return smooth_peak(run, "sin_phi").strain; },
          Claimed::above)
          .labelled("axial strain");
  for (Finding& f : strain.findings) f.counts = false;
  evidence.add(strain);
  return judged(
      {.id = "fails_at_higher_axial_stress",
       .section = "4.4",
       .figures = {19},
       .text = "At higher confining pressure the sample fails at a higher axial stress.",
       .rule = "the largest axial stress rises from 0.5 to 14 MPa, without a step that clearly "
               "falls; the axial strain at the largest sin phi is shown beside it",
       .quantity = "change of the largest axial stress, and of the strain at failure",
       .if_holds = "It has to: the axial stress is the confining pressure times a ratio that "
                   "friction bounds. Should the paper mean the axial strain, the table has it."},
      evidence);
}

Claim steeper(const Results& results, Mode breakable) {
  Evidence evidence = steeper_at_high_pressure(results, Mode::nb);
  evidence.add(steeper_at_high_pressure(results, breakable));
  return judged({.id = "pressure_matters_more_when_high",
                 .section = "4.4",
                 .figures = {19},
                 .text = "The effect of confining pressure on friction is stronger at higher "
                         "stress.",
                 .rule =
                     "the largest sin phi, averaged over 2 % of strain, falls by more with each "
                     "doubling of pressure from 4 "
                     "to 14 MPa than from 0.5 to 4 MPa",
                 .quantity = "difference of the falls with each doubling"},
                evidence);
}

Claim breakage_lowers(const Results& results, Mode breakable) {
  return judged(
      {.id = "breakage_lowers_friction",
       .section = "abstract, 4.4, 5",
       .figures = {19},
       .text = "Breakage lowers the angle of internal friction at all stress levels.",
       .rule =
           "the largest sin phi, averaged over 2 % of strain, with less without breakage, below 0 "
           "at every pressure",
       .quantity = "difference of the largest sin phi",
       .if_in_part = "Where no or few particles break there is nothing that could lower it."},
      differences(results, breakable, Mode::nb, all_pressures(), peak_friction, Claimed::below));
}

Claim breakage_depends_on_pressure(const Results& results, Mode breakable) {
  return judged(
      {.id = "breakage_grows_with_pressure",
       .section = "5",
       .figures = {19},
       .text = "Confining pressure has a considerable effect on breakage.",
       .rule = "the number of breakages in shear rises from 0.5 to 14 MPa, without a step that "
               "clearly falls",
       .quantity = "change of the number of breakages"},
      trend_with_pressure(
          results, {breakable},
          [](const Run& run) { return static_cast<double>(run.breaks_in_shear()); },
          Claimed::above));
}

Claim fabric_relation(const Results& results, Mode breakable) {
  const std::vector<Mode> both{Mode::nb, breakable};
  Evidence evidence = mean_levels(
                          results, both, all_pressures(),
                          [](const Run& run) { return gap_of_eq_14(run) / peak_friction(run); },
                          Claimed::below, 0.05)
                          .labelled("gap over peak");
  evidence.add(
      differences(results, breakable, Mode::nb, all_pressures(), gap_of_eq_14, Claimed::below)
          .unless_against()
          .labelled("effect of breakage on the gap"));
  evidence.add(trend_with_pressure(results, both, gap_of_eq_14, Claimed::below)
                   .unless_against()
                   .labelled("effect of pressure on the gap"));
  return judged(
      {.id = "eq_14_agrees",
       .section = "4.4, 5",
       .figures = {20},
       .text = "Friction by eq. 14, from the anisotropies, agrees with that by eq. 12, from the "
               "stresses, whatever the pressure and with or without breakage.",
       .rule =
           "their mean distance over shear, from 1 % of strain on, is at most a twentieth of the "
           "largest sin phi, in the mean, at every pressure; and neither breakage nor pressure "
           "clearly "
           "increases it",
       .quantity = "mean distance of eq. 14 from eq. 12",
       .if_in_part = "Eq. 14 leaves out the branch vectors, whose anisotropy slender pieces "
                     "increase, and higher harmonics; the gap of the full relation stands in the "
                     "table of results.",
       .if_not = "Eq. 14 leaves out the branch vectors and higher harmonics; the gap of the full "
                 "relation stands in the table of results."},
      evidence);
}

Claim simplified_relation(const Results& results, Mode breakable) {
  return judged(
      {.id = "eq_15_is_worse",
       .section = "4.4",
       .figures = {21},
       .text = "The simplified relation, eq. 15, deviates more than eq. 14.",
       .rule =
           "mean distance of eq. 15 from eq. 12 over shear, from 1 % of strain on, less that of "
           "eq. 14, above 0 at every pressure, with and without breakage",
       .quantity = "difference of the mean distances",
       .if_in_part = "Eq. 15 is eq. 14 times (1 + a a_n / 2), and so always the larger of the two: "
                     "where eq. 14 lies below the measured friction, eq. 15 may be the closer.",
       .if_not = "Eq. 15 is eq. 14 times (1 + a a_n / 2), and so always the larger of the two: "
                 "where eq. 14 lies below the measured friction, eq. 15 may be the closer."},
      levels(
          results, {Mode::nb, breakable}, all_pressures(),
          [](const Run& run) { return gap_of_eq_15(run) - gap_of_eq_14(run); }, Claimed::above));
}

}  // namespace

std::vector<Claim> friction_claims(const Results& results, Mode breakable) {
  return {friction_falls(results, breakable),
          fails_at_higher_stress(results, breakable),
          steeper(results, breakable),
          breakage_lowers(results, breakable),
          breakage_depends_on_pressure(results, breakable),
          fabric_relation(results, breakable),
          simplified_relation(results, breakable)};
}

}  // namespace report
