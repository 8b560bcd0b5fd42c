// SPDX-License-Identifier: BSL-1.0
// Section 4.3: anisotropies of contact normals, normal forces and tangential forces.

#include <algorithm>
#include <cmath>
#include <limits>

#include "../results/curve_features.hpp"
#include "claims.hpp"

namespace report {

namespace {

Feature between(const std::string& column, double from, double to) {
  return [=](const Run& run) { return mean_between(run, column, from, to); };
}
// From 1 % of strain on: the start is isotropic.
Feature in_shear(const std::string& column) { return between(column, 0.01, 1); }
Feature early(const std::string& column) { return between(column, 0, 0.05); }
Feature late(const std::string& column) {
  return [=](const Run& run) { return at_end(run, column); };
}

double largest_sum(const Run& run) {
  double most = 0;
  for (std::size_t i = 0; i < run.column("a").size(); ++i)
    most = std::max(most, run.column("a")[i] + run.column("a_n")[i] + run.column("a_t")[i]);
  return most;
}

double axial_growth(const Run& run) { return run.force_axial.back() - run.force_axial.front(); }

Claim normal_forces_lead(const Results& results) {
  const auto lead = [&](const std::string& other) {
    return level_part(results, {.label = "over " + other, .margin = 0.02}, both_series(),
                      all_pressures(),
                      [=](const Run& run) { return in_shear("a_n")(run) - in_shear(other)(run); });
  };
  return judged({.id = "a_n_is_largest",
                 .section = "4.3, 5",
                 .figures = {15},
                 .text = "The anisotropy of normal forces, a_n, is the largest of the three.",
                 .rule = "a_n less a, and less a_t, in the mean over shear from 1 % of strain on, "
                         "above 0 in the mean of pressures and series; less than 0.02 counts as "
                         "nothing",
                 .quantity = "difference of the coefficients"},
                {{lead("a"), lead("a_t")}});
}

Claim normal_forces_after_peak(const Results& results) {
  const Feature loss = [](const Run& run) { return loss_after_peak(run, "a_n"); };
  return judged(
      {.id = "a_n_falls_at_low_pressure_only",
       .section = "4.3, 5",
       .figures = {15, 17},
       .text = "At low confining pressure a_n has a peak and falls to a lower value; at high "
               "pressure it keeps its peak value.",
       .rule = "by the last 5 % of strain a_n has lost more than a tenth of its peak in the mean "
               "of 0.5, 1 and 2 MPa, and less than a tenth in that of 8 and 14 MPa",
       .quantity = "share of the peak that is lost"},
      {{level_part(results, {.label = "low pressure", .threshold = 0.1}, both_series(),
                   {0.5e6, 1e6, 2e6}, loss),
        level_part(results, {.label = "high pressure", .claimed = Claimed::below, .threshold = 0.1},
                   both_series(), {8e6, 14e6}, loss)}});
}

Claim axial_forces_grow(const Results& results) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  return judged(
      {.id = "axial_forces_grow_lateral_stay",
       .section = "4.3",
       .figures = {11, 15},
       .text = "Shear increases the normal forces in the axial direction, while those in the "
               "lateral direction stay nearly constant.",
       .rule = "the mean force of contacts within 45 degrees of the axial direction grows from the "
               "first to the last snapshot (less than a tenth counts as nothing), and that of the "
               "others changes by less than a quarter of this growth",
       .quantity = "growth over the first value, and ratio of the changes"},
      {{level_part(
            results, {.label = "axial growth", .margin = 0.1}, both_series(), all_pressures(),
            [](const Run& run) {
              return run.force_axial.empty() ? none : axial_growth(run) / run.force_axial.front();
            }),
        level_part(
            results,
            {.label = "lateral change over axial", .claimed = Claimed::below, .threshold = 0.25},
            both_series(), all_pressures(), [](const Run& run) {
              if (run.force_side.empty()) return none;
              return std::abs(run.force_side.back() - run.force_side.front()) /
                     std::abs(axial_growth(run));
            })}});
}

Claim normal_forces_rise(const Results& results) {
  return judged(
      {.id = "a_n_rises_faster_at_low_pressure",
       .section = "4.3",
       .figures = {15, 17},
       .text = "At low confining pressure a_n grows fast, at high pressure gradually, with and "
               "without breakage.",
       .rule = "the slope, over the logarithm of pressure, of the axial strain at which a_n has "
               "half of its peak is above 0 (less than 0.1 % counts as nothing); half, for the "
               "peak itself lies on a flat top, where scatter decides",
       .quantity = "that strain"},
      {{slope_part(results, {.margin = 0.001}, both_series(),
                   [](const Run& run) { return strain_at_share_of_peak(run, "a_n", 0.5); })}});
}

Claim tangential_forces(const Results& results) {
  return judged(
      {.id = "a_t_peaks_early",
       .section = "4.3, 5",
       .figures = {15, 18},
       .text = "The anisotropy of tangential forces, a_t, grows fast to a peak at the beginning "
               "of shear and falls slowly from there.",
       .rule = "in the mean of pressures and series the peak stands in the first quarter of the "
               "test, before 5 % of strain, and more than a tenth of it is lost by the last 5 %",
       .quantity = "strain of the peak, and share of it that is lost"},
      {{level_part(results,
                   {.label = "strain of the peak", .claimed = Claimed::below, .threshold = 0.05},
                   both_series(), all_pressures(),
                   [](const Run& run) { return smooth_peak(run, "a_t").strain; }),
        level_part(results, {.label = "share lost", .threshold = 0.1}, both_series(),
                   all_pressures(), [](const Run& run) { return loss_after_peak(run, "a_t"); })}});
}

// With less without breakage.
Part lower_with_breakage(const Results& results, const std::string& label,
                         const std::string& column, double margin) {
  return difference_part(results, {.label = label, .claimed = Claimed::below, .margin = margin},
                         all_pressures(), in_shear(column));
}

Claim less_tangential(const Results& results) {
  return judged({.id = "breakage_lowers_a_t",
                 .section = "4.3",
                 .figures = {15, 18},
                 .text = "Breakage keeps tangential forces from being mobilised in full.",
                 .rule = "a_t in the mean over shear from 1 % of strain on, with less without "
                         "breakage, below 0 in the mean of the pressures; less than 0.005 counts "
                         "as nothing",
                 .quantity = "difference of a_t"},
                {{lower_with_breakage(results, "", "a_t", 0.005)}});
}

Claim less_anisotropy(const Results& results) {
  return judged(
      {.id = "breakage_lowers_anisotropy",
       .section = "abstract, 5",
       .figures = {15, 16, 17, 18},
       .text = "Breakage lowers the anisotropy of the sample.",
       .rule = "a, a_n and a_t in the mean over shear from 1 % of strain on, with less without "
               "breakage, each below 0 in the mean of the pressures; less than 0.01 of a and a_n, "
               "and less than 0.005 of a_t, count as nothing",
       .quantity = "difference of the coefficients",
       .if_in_part = "The table of results has the number of breakages at each pressure."},
      {{lower_with_breakage(results, "a", "a", 0.01),
        lower_with_breakage(results, "a_n", "a_n", 0.01),
        lower_with_breakage(results, "a_t", "a_t", 0.005)}});
}

Claim normals_against_pressure(const Results& results) {
  const auto falls = [&](Mode mode, const Feature& feature, const std::string& label) {
    return slope_part(results, {.label = label, .claimed = Claimed::below, .margin = 0.005}, {mode},
                      feature);
  };
  return judged(
      {.id = "pressure_lowers_a",
       .section = "4.3, 5",
       .figures = {16},
       .text = "Confining pressure lowers the anisotropy of contact normals, a, but with breakage "
               "not at large strain.",
       .rule = "the slope of a over the logarithm of pressure is below 0 over the first and the "
               "last 5 % of strain (less than 0.005 counts as nothing), except with breakage over "
               "the last 5 %, where it is above -0.005",
       .quantity = "a",
       .if_in_part = "The label of a part says the series and the strain."},
      {{falls(Mode::nb, early("a"), "NB, first 5 %"), falls(Mode::nb, late("a"), "NB, last 5 %"),
        falls(Mode::wb, early("a"), "WB, first 5 %"),
        slope_part(results, {.label = "WB, last 5 %, not expected to fall", .threshold = -0.005},
                   {Mode::wb}, late("a"))}});
}

Claim forces_against_pressure(const Results& results) {
  const auto falls = [&](const std::string& name) {
    return slope_part(results, {.label = name, .claimed = Claimed::below, .margin = 0.005},
                      both_series(), early(name));
  };
  return judged({.id = "pressure_lowers_a_n_and_a_t_early",
                 .section = "4.3, 5",
                 .figures = {17, 18},
                 .text = "At low strain confining pressure lowers the anisotropies of normal and "
                         "of tangential forces, with and without breakage.",
                 .rule = "the slopes of a_n and a_t over the first 5 % of strain over the "
                         "logarithm of pressure are below 0; less than 0.005 counts as nothing",
                 .quantity = "coefficient",
                 .if_holds = "At the same strain contacts that are softer beside the pressure have "
                             "moved a smaller part of the way."},
                {{falls("a_n"), falls("a_t")}});
}

Claim more_anisotropy_at_low_pressure(const Results& results) {
  return judged(
      {.id = "low_pressure_gives_more_anisotropy",
       .section = "4.3",
       .figures = {15, 19},
       .text = "Samples at lower confining pressure reach more anisotropy, and with it more "
               "strength.",
       .rule = "the slopes of the largest sum of the three coefficients and of the largest sin phi "
               "over the logarithm of pressure are below 0; less than 0.02 and 0.005 count as "
               "nothing",
       .quantity = "largest sum, and largest sin phi"},
      {{slope_part(results, {.label = "a + a_n + a_t", .claimed = Claimed::below, .margin = 0.02},
                   both_series(), largest_sum),
        slope_part(results, {.label = "sin phi", .claimed = Claimed::below, .margin = 0.005},
                   both_series(), [](const Run& run) { return largest(run, "sin_phi"); })}});
}

Claim normals_grow(const Results& results) {
  Evidence evidence{
      {level_part(results, {.label = "in all", .margin = 0.02}, both_series(), all_pressures(),
                  [](const Run& run) { return late("a")(run) - early("a")(run); })}};
  for (const double to : {0.10, 0.15, 0.20})
    evidence.parts.push_back(level_part(
        results,
        {.label = "step to " + std::to_string(std::lround(100 * to)) + " %", .threshold = -0.01},
        both_series(), all_pressures(), [=](const Run& run) {
          return mean_between(run, "a", to - 0.05, to) -
                 mean_between(run, "a", to - 0.10, to - 0.05);
        }));
  return judged({.id = "a_grows_throughout",
                 .section = "5",
                 .figures = {16},
                 .text = "The anisotropy of contact normals grows throughout shear.",
                 .rule = "in the mean of pressures and series, a over the last 5 % of strain is "
                         "above that over the first (less than 0.02 counts as nothing), and in "
                         "none of the steps from one window of 5 % to the next it falls by 0.01 "
                         "or more",
                 .quantity = "change of a"},
                evidence);
}

}  // namespace

std::vector<Claim> anisotropy_claims(const Results& results) {
  return {normal_forces_lead(results),
          normal_forces_after_peak(results),
          axial_forces_grow(results),
          normal_forces_rise(results),
          tangential_forces(results),
          less_tangential(results),
          less_anisotropy(results),
          normals_against_pressure(results),
          forces_against_pressure(results),
          more_anisotropy_at_low_pressure(results),
          normals_grow(results)};
}

}  // namespace report
