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
// Within half of the radius that counts.
constexpr double centre_area = 0.25;

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

Claim rat_at_start(const Results& results) {
  const Feature share = [](const Run& run) {
    const std::size_t free = run.rat_at_shear_start.size();
    return free > 0 ? reached_ratf(run) / static_cast<double>(free) : none;
  };
  const std::vector<Mode> wb{Mode::wb};
  Evidence evidence{
      {level_part(results, {.label = "particles", .threshold = 1}, wb, {0.5e6}, reached_ratf),
       level_part(results, {.label = "share of the free particles", .threshold = 0.05}, wb, {0.5e6},
                  share)}};
  evidence.shown_only = level_part(results, {}, wb, {0.5e6}, largest_rat).findings;
  for (Finding& f : evidence.shown_only) f.series += ", largest Rat";
  return judged(
      {.id = "rat_at_start_of_shear",
       .section = "3.4",
       .figures = {8},
       .text = "At 0.5 MPa many particles have Rat of 0.4 and more when shear begins.",
       .rule =
           "counted are breakages in the hydrostatic stage and particles that stand at 0.4 and "
           "more when shear begins; more than one a sample, and, for \"many\", more than one in "
           "twenty of the free particles",
       .quantity = "particles at Rat of 0.4 and more, their share, and the largest Rat",
       .if_in_part = "There are some, but not many.",
       .if_not = "Stresses from 0.5 MPa, a six-hundredth of the rock's compressive strength, are "
                 "too low even in force chains: by the closed form of a disc under two forces, a "
                 "break takes 80 times the mean contact force, whatever thickness and size. With a "
                 "rock four times weaker such particles appear: see the rows of the study."},
      evidence);
}

Claim crushed_above_ratf(const Results& results) {
  return judged(
      {.id = "crushed_above_ratf",
       .section = "3.4",
       .figures = {8},
       .text = "Particles with Rat above the criterion are crushed.",
       .rule = "of the breakages before shear and the particles that stand at Rat of 0.4 and more "
               "when it begins, less than one in ten are such particles; at 8 and 14 MPa, where "
               "some have come that far",
       .quantity = "share left whole",
       .if_in_part = "The splitter refuses cuts that would leave a sliver; such particles stay "
                     "whole.",
       .if_not = "The splitter refuses cuts that would leave a sliver; such particles stay whole."},
      {{level_part(results, {.claimed = Claimed::below, .threshold = 0.1}, {Mode::wb}, {8e6, 14e6},
                   share_left_whole)}});
}

Claim centre_moves_less(const Results& results) {
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
      {{level_part(results, {.claimed = Claimed::below, .threshold = 1}, both_series(), {14e6},
                   innermost_movement)}});
}

// Beside the series, what the single runs of many particles have.
void add_large_samples(Evidence& evidence, const Results& results, const Feature& feature) {
  for (const Run& run : results.rows)
    if (run.variation == "many_particles")
      evidence.shown_only.push_back(
          {to_text(run.mode) + ", " + std::to_string(run.particles) + " particles",
           pressure_text(run.pressure), estimate({feature(run)}), Outcome::within_scatter, false});
}

Claim diagonal_bands(const Results& results) {
  const Feature direction = [](const Run& run) {
    return run.shear.empty() ? none : band_direction_excess(run.shear.back());
  };
  Evidence evidence{{level_part(results, {.margin = 0.05}, both_series(), {14e6}, direction)}};
  add_large_samples(evidence, results, direction);
  const std::string note =
      "The paper's four paths are the four quadrants in which trajectories turn from the axial to "
      "the lateral direction, which a uniform strain has as well. Shear bands are 8 to 15 "
      "diameters wide: 24 diameters across a sample of 500 particles hardly hold one.";
  return judged(
      {.id = "shear_bands_inclined",
       .section = "3.3, 4.1",
       .figures = {7},
       .text = "At 14 MPa shear localises in four bands between the axial and the lateral "
               "direction.",
       .rule = "of the tenth of the particles around which shear was largest over the last 6 % of "
               "strain, up to 18 %, pairs two to eight mean spacings apart lie more often than "
               "pairs of all particles within 22.5 degrees of 54 degrees to the lateral direction, "
               "the middle of Roscoe's and Coulomb's inclination; half is the most, and less than "
               "0.05 counts as nothing",
       .quantity = "share of such pairs, less that of all particles",
       .if_holds = note,
       .if_open = note,
       .if_not = note},
      evidence);
}

Claim bands_move_inwards(const Results& results) {
  return judged(
      {.id = "shear_bands_move_inwards",
       .section = "4.1",
       .figures = {10},
       .text = "At 2 MPa the shear bands move towards the centre as strain grows.",
       .rule = "the mean distance from the centre, over the radius, of the tenth of the particles "
               "around which shear was largest falls from the first 6 % of strain to those from 12 "
               "to 18 %; less than 0.02 counts as nothing",
       .quantity = "change of the distance over the radius"},
      {{level_part(results, {.claimed = Claimed::below, .margin = 0.02}, both_series(), {2e6},
                   [](const Run& run) {
                     return run.shear.size() < 2 ? none
                                                 : radius_of_bands(run.shear.back()) -
                                                       radius_of_bands(run.shear.front());
                   })}});
}

Claim axial_chains(const Results& results) {
  return judged(
      {.id = "axial_forces_larger",
       .section = "4.1",
       .figures = {11},
       .text = "At 2 MPa shear makes normal forces along the axial direction larger than those "
               "along the lateral one.",
       .rule = "mean normal force of contacts within 45 degrees of the axial direction, over that "
               "of the others, is above 1 at the end",
       .quantity = "ratio of mean normal forces"},
      {{level_part(results, {.threshold = 1}, both_series(), {2e6}, [](const Run& run) {
        return run.force_axial.empty() ? none : run.force_axial.back() / run.force_side.back();
      })}});
}

Claim few_in_centre(const Results& results) {
  const auto below = [&](const std::string& label, double threshold) {
    return level_part(results, {.label = label, .claimed = Claimed::below, .threshold = threshold},
                      {Mode::wb}, {4e6, 8e6, 14e6},
                      [](const Run& run) { return share_in_centre(run) / centre_area; });
  };
  Evidence evidence{{below("fewer than by area", 1), below("less than half of that", 0.5)}};
  add_large_samples(evidence, results,
                    [](const Run& run) { return share_in_centre(run) / centre_area; });
  return judged(
      {.id = "few_breaks_in_centre",
       .section = "5",
       .figures = {10},
       .text = "Breakage is minimal in the centre of the sample.",
       .rule = "of the breakages in shear within 0.9 of the radius, the share within 0.45 over its "
               "share of the area, a quarter, is below 1, and for \"minimal\", where half is our "
               "word, below a half; at 4, 8 and 14 MPa, where tens of particles break",
       .quantity = "share of breakages in the centre over its share of the area",
       .if_in_part = "There are fewer, but not few enough to be called minimal."},
      evidence);
}

Claim breaks_in_bands(const Results& results) {
  const std::vector<double> at{4e6, 8e6, 14e6};
  const std::string text =
      "The pieces' own motion after the break is part of the shear around them.";
  return judged(
      {.id = "breaks_in_shear_bands",
       .section = "5",
       .figures = {10},
       .text = "Most breakage takes place along the shear bands.",
       .rule = "more than half of the breakages in shear happen in the tenth of the particles with "
               "the most shear around them over the 6 % of strain in which they break (after 18 % "
               "of strain, over the last ones); and of all particles more than half, which is what "
               "chance gives, have less shear around them than the broken one, in the mean (less "
               "than 0.05 beyond a half counts as nothing); at 4, "
               "8 and 14 MPa",
       .quantity = "share of breakages, and mean rank",
       .if_holds = text,
       .if_in_part = text},
      {{level_part(results, {.label = "share in the bands", .threshold = 0.5}, {Mode::wb}, at,
                   share_in_bands),
        level_part(results, {.label = "more than by chance", .threshold = 0.5, .margin = 0.05},
                   {Mode::wb}, at, mean_band_share)}});
}

}  // namespace

std::vector<Claim> microstructure_claims(const Results& results) {
  return {rat_at_start(results),   crushed_above_ratf(results), centre_moves_less(results),
          diagonal_bands(results), bands_move_inwards(results), axial_chains(results),
          few_in_centre(results),  breaks_in_bands(results)};
}

}  // namespace report
