// SPDX-License-Identifier: BSL-1.0
// Section 4.2: coordination number and volume.

#include <cmath>

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

Claim falls_and_levels(const Results& results, Mode breakable) {
  const std::vector<Mode> both{Mode::nb, breakable};
  Evidence evidence = levels(results, both, all_pressures(), fall, Claimed::above).labelled("fall");
  evidence.add(mean_levels(results, both, all_pressures(), late_share, Claimed::below, 1.0 / 7)
                   .labelled("share of it in the last 5 %"));
  return judged(
      {.id = "coordination_falls_and_levels",
       .section = "4.2",
       .figures = {12},
       .text = "The coordination number falls in shear, with and without breakage, and becomes "
               "nearly constant at large strain.",
       .rule = "it is lower over the last 5 % of strain than at the start; and its change between "
               "the last two windows of 5 % is, in the mean, at most a seventh of that fall, half "
               "the pace of a "
               "steady one",
       .quantity = "fall of the coordination number (2M/N), and the last share of it",
       .if_in_part = "Where it has not levelled, 20 % of strain are not enough."},
      evidence);
}

Claim less_reduction(const Results& results, Mode breakable) {
  return judged(
      {.id = "breakage_keeps_contacts",
       .section = "4.2, 5",
       .figures = {12},
       .text = "With breakage the coordination number is reduced less, because pieces make new "
               "contacts.",
       .rule =
           "coordination number (2M/N) over the last 5 % of strain, with less without breakage, "
           "above 0 at every pressure",
       .quantity = "difference of the coordination numbers",
       .if_in_part = "Where few particles break there are few new contacts."},
      differences(results, breakable, Mode::nb, all_pressures(), coordination_at_end,
                  Claimed::above));
}

Claim more_contacts_at_2_mpa(const Results& results, Mode breakable) {
  return judged(
      {.id = "breakage_keeps_contacts_at_2_MPa",
       .section = "4.2",
       .figures = {13},
       .text = "At 2 MPa contacts are lost in shear, and breakage makes up for some of them.",
       .rule =
           "coordination number (2M/N) over the last 5 % of strain, with less without breakage, "
           "above 0 at 2 MPa",
       .quantity = "difference of the coordination numbers",
       .if_not = "The table of results has the number of breakages."},
      differences(results, breakable, Mode::nb, {2e6}, coordination_at_end, Claimed::above));
}

Claim rises_with_pressure(const Results& results, Mode breakable) {
  const std::vector<Mode> both{Mode::nb, breakable};
  Evidence evidence =
      trend_with_pressure(
          results, both, [](const Run& r) { return at_start(r, coordination); }, Claimed::above)
          .labelled("start");
  evidence.add(
      trend_with_pressure(results, both, coordination_at_end, Claimed::above).labelled("end"));
  return judged({.id = "coordination_rises_with_pressure",
                 .section = "4.2",
                 .figures = {12},
                 .text = "The higher the confining pressure, the more contacts there are.",
                 .rule = "coordination number (2M/N) at the start and over the last 5 % of strain, "
                         "each rising from 0.5 to 14 MPa, without a step that clearly falls",
                 .quantity = "change of the coordination number",
                 .if_holds = "Contacts are springs: pressure closes gaps between stiff particles."},
                evidence);
}

Claim rises_first(const Results& results, Mode breakable) {
  return judged(
      {.id = "coordination_rises_first",
       .section = "5",
       .figures = {12},
       .text = "At high confining pressures the coordination number rises before it falls.",
       .rule = "its mean over the first 1 % of strain less its value at the start, above 0 at 8 "
               "and 14 MPa",
       .quantity = "initial rise of the coordination number (2M/N)"},
      levels(
          results, {Mode::nb, breakable}, {8e6, 14e6},
          [](const Run& run) {
            return mean_between(run, coordination, 0.001, 0.01) - at_start(run, coordination);
          },
          Claimed::above));
}

// Both differences, with less without breakage, over all samples and pressures.
Evidence volume_against_coordination(const Results& results, Mode breakable) {
  std::vector<double> volumes;
  std::vector<double> contacts;
  for (const double pressure : pressures) {
    const auto difference = [&](const Feature& feature) {
      return paired(results, breakable, pressure, Mode::nb, pressure, feature);
    };
    const std::vector<double> v = difference(volume_at_end);
    const std::vector<double> c = difference(coordination_at_end);
    if (v.empty()) return {{}, {to_text(breakable) + " less NB at " + pressure_text(pressure)}};
    volumes.insert(volumes.end(), v.begin(), v.end());
    contacts.insert(contacts.end(), c.begin(), c.end());
  }
  const Estimate r = correlation(volumes, contacts);
  return {{{to_text(breakable) + " less NB", "correlation", r, outcome_above_zero(r)}}, {}};
}

}  // namespace

std::vector<Claim> coordination_claims(const Results& results, Mode breakable) {
  return {falls_and_levels(results, breakable), less_reduction(results, breakable),
          more_contacts_at_2_mpa(results, breakable), rises_with_pressure(results, breakable),
          rises_first(results, breakable)};
}

std::vector<Claim> volume_claims(const Results& results, Mode breakable) {
  const std::vector<Mode> both{Mode::nb, breakable};
  return {
      judged({.id = "breakage_lowers_dilation",
              .section = "abstract, 4.2, 5",
              .figures = {14},
              .text = "Breakage lowers dilation and increases contraction.",
              .rule = "volumetric strain (contraction positive) over the last 5 % of strain, with "
                      "less without breakage, above 0 at every pressure",
              .quantity = "difference of the volumetric strains",
              .if_in_part = "Where few particles break there is little to fill voids with."},
             differences(results, breakable, Mode::nb, all_pressures(), volume_at_end,
                         Claimed::above)),
      judged({.id = "dilation_goes_with_loss_of_contacts",
              .section = "4.2",
              .figures = {12, 14},
              .text = "Less dilation goes with a higher coordination number.",
              .rule =
                  "over all samples and pressures, the effects of breakage on volumetric strain "
                  "and on coordination number are correlated positively",
              .quantity = "coefficient of correlation"},
             volume_against_coordination(results, breakable)),
      judged({.id = "compressibility_rises_with_pressure",
              .section = "5",
              .figures = {14},
              .text = "Higher confining pressure makes the sample more compressible.",
              .rule = "volumetric strain (contraction positive) over the last 5 % of strain rises "
                      "from 0.5 to 14 MPa, without a step that clearly falls",
              .quantity = "change of the volumetric strain"},
             trend_with_pressure(results, both, volume_at_end, Claimed::above))};
}

}  // namespace report
