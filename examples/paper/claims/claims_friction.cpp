// SPDX-License-Identifier: BSL-1.0
// Section 4.4: mobilised friction, and its relation to the anisotropies.

#include <cmath>

#include "../results/curve_features.hpp"
#include "claims.hpp"

namespace report {

namespace {

double peak_friction(const Run& run) { return smooth_peak(run, "sin_phi").value; }
double gap_of_eq_14(const Run& run) { return mean_gap(run, "sin_phi_eq_14"); }
double gap_of_eq_15(const Run& run) { return mean_gap(run, "sin_phi_eq_15"); }

Claim friction_falls(const Results& results) {
  return judged(
      {.id = "friction_falls_with_pressure",
       .section = "4.4, 5",
       .figures = {19},
       .text = "Confining pressure lowers the angle of internal friction, with and without "
               "breakage.",
       .rule = "the slope of the largest sin phi, averaged over 2 % of strain, over the logarithm "
               "of pressure is below 0; less than 0.005 counts as nothing",
       .quantity = "largest sin phi",
       .if_holds =
           "Without breakage the rock's strength does not enter: what pressure changes there "
           "is kappa, pressure times thickness over stiffness."},
      {{slope_part(results, {.claimed = Claimed::below, .margin = 0.005}, both_series(),
                   peak_friction)}});
}

Claim fails_at_higher_stress(const Results& results) {
  return judged(
      {.id = "fails_at_higher_axial_stress",
       .section = "4.4",
       .figures = {19},
       .text = "At higher confining pressure the sample fails at a higher axial stress.",
       .rule =
           "the slope of the largest axial stress over the logarithm of pressure is above 0; less "
           "than 0.1 MPa counts as nothing",
       .quantity = "largest axial stress [MPa]",
       .if_holds = "It has to: the axial stress is the confining pressure times a ratio that "
                   "friction bounds. Should the paper mean the axial strain, the table of results "
                   "has it."},
      {{slope_part(results, {.margin = 0.1}, both_series(),
                   [](const Run& run) { return 1e-6 * largest(run, "sigma_22_Pa"); })}});
}

// Fall of the peak with each doubling of the pressure, from 4 to 14 MPa, less that from 0.5 to
// 4 MPa.
Claim steeper(const Results& results) {
  const double high = 1 / std::log2(14.0 / 4.0);
  const double low = 1 / std::log2(4.0 / 0.5);
  return judged(
      {.id = "pressure_matters_more_when_high",
       .section = "4.4",
       .figures = {19},
       .text = "The effect of confining pressure on friction is stronger at higher stress.",
       .rule = "the largest sin phi, averaged over 2 % of strain, falls by more with each doubling "
               "of pressure from 4 to 14 MPa than from 0.5 to 4 MPa; less than 0.003 counts as "
               "nothing",
       .quantity = "largest sin phi"},
      {{contrast_part(results, {.margin = 0.003}, both_series(), {0.5e6, 4e6, 14e6},
                      {-low, low + high, -high}, "difference of the falls with each doubling",
                      peak_friction)}});
}

Claim breakage_lowers(const Results& results) {
  return judged(
      {.id = "breakage_lowers_friction",
       .section = "abstract, 4.4, 5",
       .figures = {19},
       .text = "Breakage lowers the angle of internal friction at all stress levels.",
       .rule = "the largest sin phi, averaged over 2 % of strain, with less without breakage, is "
               "below 0 in the mean of 0.5 to 2 MPa and of 4 to 14 MPa; less than 0.005 counts as "
               "nothing",
       .quantity = "difference of the largest sin phi",
       .if_in_part = "Where no or few particles break there is nothing that could lower it."},
      {{difference_part(results,
                        {.label = "0.5 to 2 MPa", .claimed = Claimed::below, .margin = 0.005},
                        {0.5e6, 1e6, 2e6}, peak_friction),
        difference_part(results,
                        {.label = "4 to 14 MPa", .claimed = Claimed::below, .margin = 0.005},
                        {4e6, 8e6, 14e6}, peak_friction)}});
}

Claim breakage_depends_on_pressure(const Results& results) {
  return judged(
      {.id = "breakage_grows_with_pressure",
       .section = "5",
       .figures = {19},
       .text = "Confining pressure has a considerable effect on breakage.",
       .rule = "the slope of the number of breakages in shear over the logarithm of pressure is "
               "above 0; less than 20, one in twenty of the particles, counts as nothing",
       .quantity = "number of breakages"},
      {{slope_part(results, {.margin = 20}, {Mode::wb},
                   [](const Run& run) { return static_cast<double>(run.breaks_in_shear()); })}});
}

Claim fabric_relation(const Results& results) {
  const std::string text =
      "Eq. 14 leaves out the branch vectors, whose anisotropy slender pieces increase, and higher "
      "harmonics; the gap of the full relation stands in the table of results.";
  return judged(
      {.id = "eq_14_agrees",
       .section = "4.4, 5",
       .figures = {20},
       .text = "Friction by eq. 14, from the anisotropies, agrees with that by eq. 12, from the "
               "stresses, whatever the pressure and with or without breakage.",
       .rule = "their mean distance over shear, from 1 % of strain on, is less than a twentieth of "
               "the largest sin phi; breakage increases it by less than 0.005 in the mean of the "
               "pressures, and pressure by less than 0.005 with each tenfold",
       .quantity = "mean distance of eq. 14 from eq. 12",
       .if_in_part = text,
       .if_not = text},
      {{level_part(results,
                   {.label = "gap over peak", .claimed = Claimed::below, .threshold = 0.05},
                   both_series(), all_pressures(),
                   [](const Run& run) { return gap_of_eq_14(run) / peak_friction(run); }),
        difference_part(results,
                        {.label = "effect of breakage on the gap",
                         .claimed = Claimed::below,
                         .threshold = 0.005},
                        all_pressures(), gap_of_eq_14),
        slope_part(results,
                   {.label = "effect of pressure on the gap",
                    .claimed = Claimed::below,
                    .threshold = 0.005},
                   both_series(), gap_of_eq_14)}});
}

Claim simplified_relation(const Results& results) {
  const std::string text =
      "Eq. 15 is eq. 14 times (1 + a a_n / 2), and so always the larger of the two: where eq. 14 "
      "lies below the measured friction, eq. 15 may be the closer.";
  return judged(
      {.id = "eq_15_is_worse",
       .section = "4.4",
       .figures = {21},
       .text = "The simplified relation, eq. 15, deviates more than eq. 14.",
       .rule = "mean distance of eq. 15 from eq. 12 over shear, from 1 % of strain on, less that "
               "of eq. 14, is above 0 in the mean of pressures and series; less than 0.003 counts "
               "as nothing",
       .quantity = "difference of the mean distances",
       .if_in_part = text,
       .if_not = text},
      {{level_part(results, {.margin = 0.003}, both_series(), all_pressures(),
                   [](const Run& run) { return gap_of_eq_15(run) - gap_of_eq_14(run); })}});
}

}  // namespace

std::vector<Claim> friction_claims(const Results& results) {
  return {
      friction_falls(results),     fails_at_higher_stress(results),       steeper(results),
      breakage_lowers(results),    breakage_depends_on_pressure(results), fabric_relation(results),
      simplified_relation(results)};
}

}  // namespace report
