// SPDX-License-Identifier: BSL-1.0
// Sections 3.4 and 4.1: Rat, movement, bands, force chains, places of breakage.

#include <algorithm>
#include <cmath>
#include <limits>

#include "claims.hpp"

namespace report {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr double ratf = 0.4;

double left_above_ratf(const Run& run) {
  return static_cast<double>(std::count_if(run.rat_at_shear_start.begin(),
                                           run.rat_at_shear_start.end(),
                                           [](double rat) { return rat >= ratf; }));
}

double largest_rat(const Run& run) {
  const auto& all = run.rat_at_shear_start;
  return all.empty() ? none : *std::max_element(all.begin(), all.end());
}

// Particles that broke before shear, or stand at RatF and more when it begins.
double reached_ratf(const Run& run) {
  return left_above_ratf(run) + static_cast<double>(run.breaks.size() - run.breaks_in_shear());
}

double innermost_movement(const Run& run) {
  const auto& movement = run.ring_displacement;
  if (movement.size() < 2) return none;
  return movement.front() / *std::min_element(movement.begin() + 1, movement.end());
}

double share_in_centre(const Run& run) {
  double centre = 0;
  double all = 0;
  for (const Break& b : run.breaks)
    if (b.in_shear && b.radius_share < 0.9) {
      ++all;
      centre += b.radius_share < 0.45;
    }
  return all > 0 ? centre / all : none;
}

// Mean of a value over the breakages in shear of which the shear around them is known.
double mean_over_breaks(const Run& run, double (*value)(double band_share)) {
  double sum = 0;
  double count = 0;
  for (const Break& b : run.breaks)
    if (b.in_shear && b.band_share) {
      sum += value(*b.band_share);
      ++count;
    }
  return count > 0 ? sum / count : none;
}

double mean_band_share(const Run& run) {
  return mean_over_breaks(run, [](double share) { return share; });
}

double share_in_bands(const Run& run) {
  return mean_over_breaks(run, [](double share) { return share >= 0.9 ? 1.0 : 0.0; });
}

// Of the particles that reached RatF before shear, how many are still whole when it begins.
double share_left_whole(const Run& run) {
  const double reached = reached_ratf(run);
  return reached > 0 ? left_above_ratf(run) / reached : none;
}

Claim rat_at_start(const Results& results, Mode breakable) {
  const Feature share = [](const Run& run) {
    const std::size_t free = run.rat_at_shear_start.size();
    return free > 0 ? reached_ratf(run) / static_cast<double>(free) : none;
  };
  Evidence evidence = mean_levels(results, {breakable}, {0.5e6}, reached_ratf, Claimed::above, 1)
                          .labelled("particles");
  evidence.add(mean_levels(results, {breakable}, {0.5e6}, share, Claimed::above, 0.05)
                   .labelled("share of the free particles"));
  Evidence largest =
      levels(results, {breakable}, {0.5e6}, largest_rat, Claimed::above).labelled("largest Rat");
  for (Finding& f : largest.findings) f.counts = false;
  evidence.add(largest);
  return judged(
      {.id = "rat_at_start_of_shear",
       .section = "3.4",
       .figures = {8},
       .text = "At 0.5 MPa many particles have Rat of 0.4 and more when shear begins.",
       .rule = "counted are breakages in the hydrostatic stage and particles that stand at 0.4 and "
               "more "
               "when shear begins; at least one a sample in the mean, and, for \"many\", at least "
               "one in twenty "
               "of the free particles",
       .quantity = "particles at Rat of 0.4 and more, their share, and the largest Rat",
       .if_in_part = "There are some, but not many.",
       .if_not = "The largest Rat stands in the table: stresses from 0.5 MPa, a six-hundredth of "
                 "the rock's compressive strength, are too low even in force chains."},
      evidence);
}

Claim crushed_above_ratf(const Results& results, Mode breakable) {
  return judged(
      {.id = "crushed_above_ratf",
       .section = "3.4",
       .figures = {8},
       .text = "Particles with Rat above the criterion are crushed.",
       .rule = "of the breakages before shear and the particles that stand at Rat of 0.4 and more "
               "when it begins, at most one in ten are such particles, in the mean; at 8 and 14 "
               "MPa, where some have come that far",
       .quantity = "share left whole",
       .if_in_part = "The splitter refuses cuts that would leave a sliver; such particles stay "
                     "whole.",
       .if_not = "The splitter refuses cuts that would leave a sliver; such particles stay whole."},
      mean_levels(results, {breakable}, {8e6, 14e6}, share_left_whole, Claimed::below, 0.1));
}

Claim centre_moves_less(const Results& results, Mode breakable) {
  return judged(
      {.id = "centre_moves_less",
       .section = "4.1",
       .figures = {7},
       .text = "At 14 MPa particles in the centre move less than those further out, with and "
               "without breakage.",
       .rule =
           "mean displacement over shear within a fifth of the radius, over the smallest of the "
           "four rings around it, is below 1",
       .quantity = "ratio of mean displacements",
       .if_holds = "Uniform strain alone would give 0.43, so the statement says little about the "
                   "particles."},
      levels(results, {Mode::nb, breakable}, {14e6}, innermost_movement, Claimed::below, 1));
}

Claim diagonal_bands(const Results& results, Mode breakable) {
  return judged(
      {.id = "shear_bands_on_diagonals",
       .section = "3.3, 4.1",
       .figures = {7},
       .text = "At 14 MPa shear localises in four bands between the axial and the lateral "
               "direction.",
       .rule = "of the tenth of the particles around which shear was largest over the last 6 % of "
               "strain, up to 18 %, more than half lie within 22.5 degrees of a diagonal through "
               "the centre; half is what chance gives",
       .quantity = "share near a diagonal"},
      levels(
          results, {Mode::nb, breakable}, {14e6},
          [](const Run& run) { return run.bands.empty() ? none : run.bands.back().diagonal_share; },
          Claimed::above, 0.5));
}

Claim bands_move_inwards(const Results& results, Mode breakable) {
  return judged({.id = "shear_bands_move_inwards",
                 .section = "4.1",
                 .figures = {10},
                 .text = "At 2 MPa the shear bands move towards the centre as strain grows.",
                 .rule = "the mean distance from the centre, over the radius, of the tenth of the "
                         "particles around which shear was largest falls from the first 6 % of "
                         "strain to those from 12 to 18 %",
                 .quantity = "change of the distance over the radius"},
                levels(
                    results, {Mode::nb, breakable}, {2e6},
                    [](const Run& run) {
                      return run.bands.size() < 2
                                 ? none
                                 : run.bands.back().radius_share - run.bands.front().radius_share;
                    },
                    Claimed::below));
}

Claim axial_chains(const Results& results, Mode breakable) {
  return judged(
      {.id = "axial_forces_larger",
       .section = "4.1",
       .figures = {11},
       .text = "At 2 MPa shear makes normal forces along the axial direction larger than those "
               "along the lateral one.",
       .rule = "mean normal force of contacts within 45 degrees of the axial direction, over that "
               "of the others, is above 1 at the end",
       .quantity = "ratio of mean normal forces"},
      levels(
          results, {Mode::nb, breakable}, {2e6},
          [](const Run& run) {
            return run.force_axial.empty() ? none : run.force_axial.back() / run.force_side.back();
          },
          Claimed::above, 1));
}

Claim few_in_centre(const Results& results, Mode breakable) {
  const std::vector<double> at{4e6, 8e6, 14e6};
  Evidence evidence = levels(results, {breakable}, at, share_in_centre, Claimed::below, 0.25)
                          .labelled("fewer than by area");
  evidence.add(mean_levels(results, {breakable}, at, share_in_centre, Claimed::below, 0.125)
                   .labelled("less than half of that"));
  return judged(
      {.id = "few_breaks_in_centre",
       .section = "5",
       .figures = {10},
       .text = "Breakage is minimal in the centre of the sample.",
       .rule =
           "of the breakages in shear within 0.9 of the radius, the share within 0.45 is below "
           "a quarter, its share of the area, and for \"minimal\" at most half of that; at 4, 8 "
           "and 14 MPa, where tens of particles break",
       .quantity = "share of breakages in the centre",
       .if_in_part = "There are fewer in some of the tests, or not few enough to be called "
                     "minimal."},
      evidence);
}

Claim breaks_in_bands(const Results& results, Mode breakable) {
  const std::vector<double> at{4e6, 8e6, 14e6};
  Evidence evidence = mean_levels(results, {breakable}, at, share_in_bands, Claimed::above, 0.5)
                          .labelled("share in the bands");
  evidence.add(levels(results, {breakable}, at, mean_band_share, Claimed::above, 0.5)
                   .labelled("more than by chance"));
  return judged(
      {.id = "breaks_in_shear_bands",
       .section = "5",
       .figures = {10},
       .text = "Most breakage takes place along the shear bands.",
       .rule = "at least half of the breakages in shear happen in the tenth of the particles with "
               "the most shear around them over the 6 % of strain in which they break (after 18 % "
               "of strain, over the last ones); and of all particles more than half, which is what "
               "chance gives, have less shear around them than the broken one, in the mean; at 4, "
               "8 and 14 MPa",
       .quantity = "share of breakages, and mean rank",
       .if_holds = "The pieces' own motion after the break is part of the shear around them.",
       .if_in_part = "The pieces' own motion after the break is part of the shear around them."},
      evidence);
}

}  // namespace

std::vector<Claim> microstructure_claims(const Results& results, Mode breakable) {
  return {rat_at_start(results, breakable),       crushed_above_ratf(results, breakable),
          centre_moves_less(results, breakable),  diagonal_bands(results, breakable),
          bands_move_inwards(results, breakable), axial_chains(results, breakable),
          few_in_centre(results, breakable),      breaks_in_bands(results, breakable)};
}

}  // namespace report
