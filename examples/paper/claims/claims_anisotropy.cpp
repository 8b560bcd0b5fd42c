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

Claim normal_forces_lead(const Results& results, Mode breakable) {
  const std::vector<Mode> both{Mode::nb, breakable};
  Evidence evidence;
  for (const std::string other : {"a", "a_t"})
    evidence.add(levels(
                     results, both, all_pressures(),
                     [&](const Run& run) { return in_shear("a_n")(run) - in_shear(other)(run); },
                     Claimed::above)
                     .labelled("over " + other));
  return judged({.id = "a_n_is_largest",
                 .section = "4.3, 5",
                 .figures = {15},
                 .text = "The anisotropy of normal forces, a_n, is the largest of the three.",
                 .rule = "a_n less a, and less a_t, in the mean over shear from 1 % of strain on, "
                         "above 0 at every pressure, with and without breakage",
                 .quantity = "difference of the coefficients"},
                evidence);
}

Claim normal_forces_after_peak(const Results& results, Mode breakable) {
  const std::vector<Mode> both{Mode::nb, breakable};
  const Feature loss = [](const Run& run) { return loss_after_peak(run, "a_n"); };
  Evidence evidence = mean_levels(results, both, {0.5e6, 1e6, 2e6}, loss, Claimed::above, 0.1);
  evidence.add(mean_levels(results, both, {8e6, 14e6}, loss, Claimed::below, 0.1));
  return judged(
      {.id = "a_n_falls_at_low_pressure_only",
       .section = "4.3, 5",
       .figures = {15, 17},
       .text = "At low confining pressure a_n has a peak and falls to a lower value; at high "
               "pressure it keeps its peak value.",
       .rule =
           "in the mean a_n loses at least a tenth of its peak by the last 5 % of strain at 0.5, "
           "1 and 2 MPa, and at most a tenth at 8 and 14 MPa",
       .quantity = "share of the peak that is lost"},
      evidence);
}

Claim axial_forces_grow(const Results& results, Mode breakable) {
  const std::vector<Mode> both{Mode::nb, breakable};
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Evidence evidence =
      levels(
          results, both, all_pressures(),
          [](const Run& run) {
            return run.force_axial.empty() ? none : axial_growth(run) / run.force_axial.front();
          },
          Claimed::above)
          .labelled("axial growth");
  evidence.add(mean_levels(
                   results, both, all_pressures(),
                   [](const Run& run) {
                     if (run.force_side.empty()) return none;
                     return std::abs(run.force_side.back() - run.force_side.front()) /
                            std::abs(axial_growth(run));
                   },
                   Claimed::below, 0.25)
                   .labelled("lateral change over axial"));
  return judged(
      {.id = "axial_forces_grow_lateral_stay",
       .section = "4.3",
       .figures = {11, 15},
       .text = "Shear increases the normal forces in the axial direction, while those in the "
               "lateral direction stay nearly constant.",
       .rule =
           "the mean force of contacts within 45 degrees of the axial direction grows from the "
           "first to the last snapshot, and that of the others changes, in the mean, by at most a "
           "quarter of this growth",
       .quantity = "growth over the first value, and ratio of the changes"},
      evidence);
}

Claim normal_forces_rise(const Results& results, Mode breakable) {
  return judged(
      {.id = "a_n_rises_faster_at_low_pressure",
       .section = "4.3",
       .figures = {15, 17},
       .text = "At low confining pressure a_n grows fast, at high pressure gradually, with and "
               "without breakage.",
       .rule =
           "the axial strain at which a_n has half of its peak rises from 0.5 to 14 MPa, without a "
           "step that clearly falls; half, for the peak itself lies on a flat top, where scatter "
           "decides",
       .quantity = "change of that strain"},
      trend_with_pressure(
          results, {Mode::nb, breakable},
          [](const Run& run) { return strain_at_share_of_peak(run, "a_n", 0.5); }, Claimed::above));
}

Claim tangential_forces(const Results& results, Mode breakable) {
  const std::vector<Mode> both{Mode::nb, breakable};
  Evidence evidence =
      mean_levels(
          results, both, all_pressures(),
          [](const Run& run) { return smooth_peak(run, "a_t").strain; }, Claimed::below, 0.05)
          .labelled("strain of the peak");
  evidence.add(mean_levels(
                   results, both, all_pressures(),
                   [](const Run& run) { return loss_after_peak(run, "a_t"); }, Claimed::above, 0.1)
                   .labelled("share lost"));
  return judged(
      {.id = "a_t_peaks_early",
       .section = "4.3, 5",
       .figures = {15, 18},
       .text = "The anisotropy of tangential forces, a_t, grows fast to a peak at the beginning "
               "of shear and falls slowly from there.",
       .rule =
           "in the mean the peak stands in the first quarter of the test, up to 5 % of strain, and "
           "at least a tenth of it is lost by the last 5 %; at every pressure",
       .quantity = "strain of the peak, and share of it that is lost"},
      evidence);
}

Claim less_tangential(const Results& results, Mode breakable) {
  return judged(
      {.id = "breakage_lowers_a_t",
       .section = "4.3",
       .figures = {15, 18},
       .text = "Breakage keeps tangential forces from being mobilised in full.",
       .rule = "a_t in the mean over shear from 1 % of strain on, with less without "
               "breakage, below 0 at every pressure",
       .quantity = "difference of a_t"},
      differences(results, breakable, Mode::nb, all_pressures(), in_shear("a_t"), Claimed::below));
}

Claim less_anisotropy(const Results& results, Mode breakable) {
  Evidence evidence;
  for (const std::string name : {"a", "a_n", "a_t"})
    evidence.add(
        differences(results, breakable, Mode::nb, all_pressures(), in_shear(name), Claimed::below)
            .labelled(name));
  return judged(
      {.id = "breakage_lowers_anisotropy",
       .section = "abstract, 5",
       .figures = {15, 16, 17, 18},
       .text = "Breakage lowers the anisotropy of the sample.",
       .rule = "a, a_n and a_t in the mean over shear from 1 % of strain on, with less "
               "without breakage, each below 0 at every pressure",
       .quantity = "difference of the coefficients",
       .if_in_part = "The table of results has the number of breakages at each pressure."},
      evidence);
}

Claim normals_against_pressure(const Results& results, Mode breakable) {
  const auto trend = [&](Mode mode, const Feature& feature, const std::string& when) {
    return trend_with_pressure(results, {mode}, feature, Claimed::below).labelled(when);
  };
  Evidence evidence = trend(Mode::nb, early("a"), "first 5 %");
  evidence.add(trend(Mode::nb, late("a"), "last 5 %"));
  evidence.add(trend(breakable, early("a"), "first 5 %"));
  Evidence exception = trend(breakable, late("a"), "last 5 %, not expected to fall");
  for (Finding& f : exception.findings)
    f.outcome = f.outcome == Outcome::agrees ? Outcome::against : Outcome::agrees;
  evidence.add(exception);
  return judged(
      {.id = "pressure_lowers_a",
       .section = "4.3, 5",
       .figures = {16},
       .text = "Confining pressure lowers the anisotropy of contact normals, a, but with breakage "
               "not at large strain.",
       .rule =
           "a over the first and the last 5 % of strain falls from 0.5 to 14 MPa without a step "
           "that clearly rises, except with breakage over the last 5 %, where it must not",
       .quantity = "change of a"},
      evidence);
}

Claim forces_against_pressure(const Results& results, Mode breakable) {
  Evidence evidence;
  for (const std::string name : {"a_n", "a_t"})
    evidence.add(trend_with_pressure(results, {Mode::nb, breakable}, early(name), Claimed::below)
                     .labelled(name));
  return judged({.id = "pressure_lowers_a_n_and_a_t_early",
                 .section = "4.3, 5",
                 .figures = {17, 18},
                 .text = "At low strain confining pressure lowers the anisotropies of normal and "
                         "of tangential forces, with and without breakage.",
                 .rule = "a_n and a_t over the first 5 % of strain fall from 0.5 to 14 MPa without "
                         "a step that clearly rises",
                 .quantity = "change of the coefficient",
                 .if_holds = "At the same strain contacts that are softer beside the pressure have "
                             "moved a smaller part of the way."},
                evidence);
}

Claim more_anisotropy_at_low_pressure(const Results& results, Mode breakable) {
  const std::vector<Mode> both{Mode::nb, breakable};
  Evidence evidence =
      trend_with_pressure(results, both, largest_sum, Claimed::below).labelled("a + a_n + a_t");
  evidence.add(
      trend_with_pressure(
          results, both, [](const Run& run) { return largest(run, "sin_phi"); }, Claimed::below)
          .labelled("sin phi"));
  return judged({.id = "low_pressure_gives_more_anisotropy",
                 .section = "4.3",
                 .figures = {15, 19},
                 .text = "Samples at lower confining pressure reach more anisotropy, and with it "
                         "more strength.",
                 .rule = "the largest sum of the three coefficients and the largest sin phi both "
                         "fall from 0.5 to 14 MPa, without a step that clearly rises",
                 .quantity = "change of the largest sum, and of the largest sin phi"},
                evidence);
}

Claim normals_grow(const Results& results, Mode breakable) {
  const std::vector<Mode> both{Mode::nb, breakable};
  Evidence evidence;
  for (const double to : {0.10, 0.15, 0.20})
    evidence.add(levels(
                     results, both, all_pressures(),
                     [=](const Run& run) {
                       return mean_between(run, "a", to - 0.05, to) -
                              mean_between(run, "a", to - 0.10, to - 0.05);
                     },
                     Claimed::above)
                     .unless_against()
                     .labelled("step to " + std::to_string(std::lround(100 * to)) + " %"));
  evidence.add(levels(
                   results, both, all_pressures(),
                   [](const Run& run) { return late("a")(run) - early("a")(run); }, Claimed::above)
                   .labelled("in all"));
  return judged({.id = "a_grows_throughout",
                 .section = "5",
                 .figures = {16},
                 .text = "The anisotropy of contact normals grows throughout shear.",
                 .rule = "a over the last 5 % of strain is above that over the first, and none of "
                         "the steps from one window of 5 % to the next clearly falls; at every "
                         "pressure",
                 .quantity = "change of a"},
                evidence);
}

}  // namespace

std::vector<Claim> anisotropy_claims(const Results& results, Mode breakable) {
  return {normal_forces_lead(results, breakable),
          normal_forces_after_peak(results, breakable),
          axial_forces_grow(results, breakable),
          normal_forces_rise(results, breakable),
          tangential_forces(results, breakable),
          less_tangential(results, breakable),
          less_anisotropy(results, breakable),
          normals_against_pressure(results, breakable),
          forces_against_pressure(results, breakable),
          more_anisotropy_at_low_pressure(results, breakable),
          normals_grow(results, breakable)};
}

}  // namespace report
