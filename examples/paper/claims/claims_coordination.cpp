// SPDX-License-Identifier: BSL-1.0
// Section 4.2: coordination number and volume.

#include <array>
#include <cmath>
#include <map>

#include "../results/curve_features.hpp"
#include "claims.hpp"

namespace report {

namespace {

constexpr auto coordination = "coordination_number";
constexpr auto volume = "volumetric_strain";

double coordination_at_end(const Run& run) { return at_end(run, coordination); }
double volume_at_end(const Run& run) { return at_end(run, volume); }
double fall(const Run& run) { return at_start(run, coordination) - at_end(run, coordination); }

// Share of the fall that comes in the last 5 %; a steady fall gives 5 of the 17.5 % between the
// start and the middle of the last window.
double late_share(const Run& run) {
  const double end = run.column("axial_strain").back();
  return std::abs(
      (mean_between(run, coordination, end - 0.10, end - 0.05) - at_end(run, coordination)) /
      fall(run));
}

Claim falls_and_levels(const Results& results) {
  return judged(
      {.id = "coordination_falls_and_levels",
       .section = "4.2",
       .figures = {12},
       .text = "The coordination number falls in shear, with and without breakage, and becomes "
               "nearly constant at large strain.",
       .rule = "it is lower over the last 5 % of strain than at the start (less than 0.1 counts as "
               "nothing); and its change between "
               "the last two windows of 5 % is less than a seventh of that fall, half the pace of "
               "a steady one",
       .quantity = "fall of the coordination number (2M/N), and the last share of it",
       .if_in_part = "Where it has not levelled, 20 % of strain are not enough."},
      {{level_part(results, {.label = "fall", .margin = 0.1}, both_series(), all_pressures(), fall),
        level_part(results,
                   {.label = "share of it in the last 5 %",
                    .claimed = Claimed::below,
                    .threshold = 1.0 / 7},
                   both_series(), all_pressures(), late_share)}});
}

Claim less_reduction(const Results& results) {
  return judged(
      {.id = "breakage_keeps_contacts",
       .section = "4.2, 5",
       .figures = {12},
       .text = "With breakage the coordination number is reduced less, because pieces make new "
               "contacts.",
       .rule =
           "coordination number (2M/N) over the last 5 % of strain, with less without breakage, "
           "above 0 in the mean of the pressures; less than 0.05 counts as nothing",
       .quantity = "difference of the coordination numbers"},
      {{difference_part(results, {.margin = 0.05}, all_pressures(), coordination_at_end)}});
}

Claim more_contacts_at_2_mpa(const Results& results) {
  return judged(
      {.id = "breakage_keeps_contacts_at_2_MPa",
       .section = "4.2",
       .figures = {13},
       .text = "At 2 MPa contacts are lost in shear, and breakage makes up for some of them.",
       .rule =
           "coordination number (2M/N) over the last 5 % of strain, with less without breakage, "
           "above 0 at 2 MPa; less than 0.05 counts as nothing",
       .quantity = "difference of the coordination numbers",
       .if_open = "The table of results has the number of breakages.",
       .if_not = "The table of results has the number of breakages."},
      {{difference_part(results, {.margin = 0.05}, {2e6}, coordination_at_end)}});
}

Claim rises_with_pressure(const Results& results) {
  return judged(
      {.id = "coordination_rises_with_pressure",
       .section = "4.2",
       .figures = {12},
       .text = "The higher the confining pressure, the more contacts there are.",
       .rule =
           "the slope of the coordination number (2M/N) over the logarithm of pressure, at the "
           "start and over the last 5 % of strain, is above 0; less than 0.05 counts as nothing",
       .quantity = "coordination number",
       .if_holds = "Contacts are springs: pressure closes gaps between stiff particles."},
      {{slope_part(results, {.label = "start", .margin = 0.05}, both_series(),
                   [](const Run& r) { return at_start(r, coordination); }),
        slope_part(results, {.label = "end", .margin = 0.05}, both_series(),
                   coordination_at_end)}});
}

Claim rises_first(const Results& results) {
  return judged(
      {.id = "coordination_rises_first",
       .section = "5",
       .figures = {12},
       .text = "At high confining pressures the coordination number rises before it falls.",
       .rule = "its mean over the first 1 % of strain less its value at the start, above 0 in the "
               "mean of 8 and 14 MPa; less than 0.01 counts as nothing",
       .quantity = "initial rise of the coordination number (2M/N)"},
      {{level_part(results, {.margin = 0.01}, both_series(), {8e6, 14e6}, [](const Run& run) {
        return mean_between(run, coordination, 0.001, 0.01) - at_start(run, coordination);
      })}});
}

// Of the effects of breakage on volume and on coordination, over the pressures, a sample each.
Part correlation_part(const Results& results) {
  Part part{.quantity = "mean correlation of a sample's six pressures", .margin = 0.3};
  std::map<int, std::array<std::vector<double>, 2>> effects;
  for (const double pressure : pressures) {
    const auto difference = [&](const Feature& feature) {
      return less(cell(results.of(Mode::wb, pressure), feature),
                  cell(results.of(Mode::nb, pressure), feature));
    };
    const Cell volumes = difference(volume_at_end);
    const Cell contacts = difference(coordination_at_end);
    if (volumes.empty()) part.missing.push_back("WB less NB at " + pressure_text(pressure));
    for (const auto& [sample, v] : volumes) {
      const auto found = contacts.find(sample);
      if (found == contacts.end()) continue;
      effects[sample][0].push_back(v);
      effects[sample][1].push_back(found->second);
    }
  }
  std::vector<double> all;
  for (const auto& [sample, e] : effects)
    if (e[0].size() == pressures.size()) all.push_back(correlation(e[0], e[1]));
  if (all.size() < 2) part.missing.push_back("two samples at all pressures");
  if (!part.missing.empty()) return part;
  part.pooled = estimate(all);
  part.shown = shown_by(part.pooled, part.margin);
  return part;
}

}  // namespace

std::vector<Claim> coordination_claims(const Results& results) {
  return {falls_and_levels(results), less_reduction(results), more_contacts_at_2_mpa(results),
          rises_with_pressure(results), rises_first(results)};
}

std::vector<Claim> volume_claims(const Results& results) {
  return {
      judged({.id = "breakage_lowers_dilation",
              .section = "abstract, 4.2, 5",
              .figures = {14},
              .text = "Breakage lowers dilation and increases contraction.",
              .rule =
                  "volumetric strain (contraction positive) over the last 5 % of strain, with "
                  "less without breakage, above 0 in the mean of the pressures; less than 0.2 % "
                  "counts as nothing",
              .quantity = "difference of the volumetric strains"},
             {{difference_part(results, {.margin = 0.002}, all_pressures(), volume_at_end)}}),
      judged({.id = "dilation_goes_with_loss_of_contacts",
              .section = "4.2",
              .figures = {12, 14},
              .text = "Less dilation goes with a higher coordination number.",
              .rule = "over the pressures, the effects of breakage on volumetric strain and on "
                      "coordination number are correlated positively, in the mean of the samples; "
                      "less than 0.3 counts as nothing",
              .quantity = "coefficient of correlation"},
             {{correlation_part(results)}}),
      judged({.id = "compressibility_rises_with_pressure",
              .section = "5",
              .figures = {14},
              .text = "Higher confining pressure makes the sample more compressible.",
              .rule = "the slope of the volumetric strain (contraction positive) over the last 5 % "
                      "of strain over the logarithm of pressure is above 0; less than 0.5 % counts "
                      "as nothing",
              .quantity = "volumetric strain"},
             {{slope_part(results, {.margin = 0.005}, both_series(), volume_at_end)}})};
}

}  // namespace report
