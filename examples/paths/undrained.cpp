// SPDX-License-Identifier: BSL-1.0
// Shear at constant volume of a dense sample, compacted without friction, and of a loose one,
// compacted with all of it.

#include <algorithm>

#include <riprap/experiment/paths/shear.hpp>
#include <riprap/experiment/preparation.hpp>

#include "report.hpp"

namespace paths {

namespace {

constexpr double pressure = 2e6;
constexpr auto dense = "dense";
constexpr auto loose = "loose";

// Where the total sigma_11 stays at the confining pressure, the fluid bears what the particles do
// not [Pa].
double pore_pressure(const riprap::CurvePoint& p) { return pressure - p.stress.s11; }
double half_difference(const riprap::CurvePoint& p) { return in_mpa(0.5 * difference(p)); }

// A value for each sample of a variant.
struct Undrained {
  std::vector<double> porosity{};  // at the start
  std::vector<double> mean{};      // effective mean stress at the end [Pa]
  std::vector<double> least{};     // lowest effective mean stress [Pa]
  std::vector<double> sin_phi{};   // at the end
  std::vector<double> pore{};      // pore pressure at the end [Pa]
  std::vector<double> hardin{};
};

Undrained undrained_of(const std::vector<Run>& runs, const char* variant) {
  Undrained u;
  for (const Run* run : runs_of(runs, variant)) {
    const riprap::CurvePoint& end = run->points.back();
    u.porosity.push_back(run->points.front().porosity);
    u.mean.push_back(end.stress.mean());
    double least = end.stress.mean();
    for (const auto& p : run->points) least = std::min(least, p.stress.mean());
    u.least.push_back(least);
    u.sin_phi.push_back(end.sin_phi());
    u.pore.push_back(pore_pressure(end));
    u.hardin.push_back(run->hardin.back());
  }
  return u;
}

}  // namespace

std::vector<PlannedRun> plan_undrained(const Options& o) {
  std::vector<PlannedRun> runs;
  for (const char* variant : {dense, loose}) {
    PlannedRun run{.variant = variant, .pressure = pressure};
    run.stages = riprap::Preparation{}.stages(pressure);
    run.stages.front().friction = variant == loose;  // the first stage is compaction
    run.stages.push_back(riprap::constant_volume_shear(
        {.axial_strain = o.quick ? 0.02 : 0.2, .record_every = 0.001}));
    add_runs(runs, o, run);
  }
  return runs;
}

Findings find_undrained(const Options& /*o*/, const std::vector<Run>& runs) {
  const Value strain = [](const auto& p) { return in_per_cent(p.axial_strain); };
  const Value mean = [](const auto& p) { return in_mpa(p.stress.mean()); };
  riprap::Chart path = chart("Effective stress path at constant volume", "(s11 + s22) / 2 [MPa]",
                             "(s22 - s11) / 2 [MPa]");
  riprap::Chart shear = chart("Shear stress", "axial strain [%]", "(s22 - s11) / 2 [MPa]");
  riprap::Chart pore =
      chart("Pore pressure at a total s11 of 2 MPa", "axial strain [%]", "2 MPa - s11 [MPa]");
  riprap::Chart ratio = chart("Stress ratio", "axial strain [%]", "sin phi [-]");
  Findings out;
  for (const char* variant : {dense, loose}) {
    const char* const colour = variant == dense ? blue : orange;
    add_curves(path, runs, variant, variant, colour, mean, half_difference);
    add_curves(shear, runs, variant, variant, colour, strain, half_difference);
    add_curves(pore, runs, variant, variant, colour, strain,
               [](const auto& p) { return in_mpa(pore_pressure(p)); });
    add_curves(ratio, runs, variant, variant, colour, strain,
               [](const auto& p) { return p.sin_phi(); });
    const Undrained u = undrained_of(runs, variant);
    out.numbers[variant] = {{"porosity_at_the_start", spread(u.porosity)},
                            {"mean_stress_at_the_end_Pa", spread(u.mean)},
                            {"lowest_mean_stress_Pa", spread(u.least)},
                            {"sin_phi_at_the_end", spread(u.sin_phi)},
                            {"pore_pressure_at_the_end_Pa", spread(u.pore)},
                            {"hardin_b_r_at_the_end", spread(u.hardin)}};
    out.lines.push_back(std::string(variant) + ", porosity " + spread_text(u.porosity) +
                        ": at the end mean stress " + spread_text(u.mean, 1e-6) + " MPa (lowest " +
                        spread_text(u.least, 1e-6) + "), sin phi " + spread_text(u.sin_phi) +
                        ", pore pressure " + spread_text(u.pore, 1e-6, "MPa"));
  }
  out.charts = {path, shear, pore, ratio};
  return out;
}

}  // namespace paths
