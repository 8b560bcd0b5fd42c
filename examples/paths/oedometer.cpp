// SPDX-License-Identifier: BSL-1.0
// The oedometer test with three loops, and the friction of the same samples for Jaky's K0.

#include <algorithm>

#include <riprap/experiment/paths/oedometer.hpp>
#include <riprap/experiment/paths/shear.hpp>
#include <riprap/experiment/preparation.hpp>

#include "report.hpp"

namespace paths {

namespace {

// Of both tests [Pa]; contacts this stiff jam at nearly as much.
constexpr double first_pressure = 4e6;
// A weak rock with stiff contacts: its particles yield before the springs are compressed by much.
constexpr double strength = 60e6;
constexpr double stiffness = 8e7;
constexpr auto oedometer = "oedometer";
constexpr auto drained = "drained shear";

std::vector<double> stresses(const Options& o) {
  if (o.quick) return {8e6, 2e6, 12e6};
  return {8e6, 2e6, 16e6, 4e6, 24e6, 6e6, 32e6};
}

double k0(const riprap::CurvePoint& p) { return p.stress.s11 / p.stress.s22; }

}  // namespace

std::vector<PlannedRun> plan_oedometer(const Options& o) {
  std::vector<PlannedRun> runs;
  PlannedRun run{.variant = oedometer, .pressure = first_pressure};
  run.sample.strength = strength;
  run.sample.stiffness = stiffness;
  run.stages = riprap::Preparation{}.stages(first_pressure);
  for (auto& stage :
       riprap::Oedometer{.vertical_stresses = stresses(o), .record_every = 0.0005}.stages(
           first_pressure))
    run.stages.push_back(std::move(stage));
  run.picture = "After the oedometer test";
  add_runs(runs, o, run);
  PlannedRun shear{.variant = drained, .sample = run.sample, .pressure = first_pressure};
  shear.stages = riprap::Preparation{}.stages(first_pressure);
  shear.stages.push_back(
      riprap::drained_shear(first_pressure, {.axial_strain = o.quick ? 0.03 : 0.1}));
  add_runs(runs, o, shear);
  return runs;
}

Findings find_oedometer(const Options& o, const std::vector<Run>& runs) {
  const Value strain = [](const auto& p) { return in_per_cent(p.axial_strain); };
  const Value stress = [](const auto& p) { return in_mpa(p.stress.s22); };
  const Value breakages = [](const auto& p) { return static_cast<double>(p.breakages); };
  Findings out;
  std::vector<std::vector<double>> at_ends(stresses(o).size());
  std::vector<double> hardin;
  std::vector<double> count;
  for (const Run* run : runs_of(runs, oedometer)) {
    for (std::size_t k = 0; k < at_ends.size(); ++k)
      at_ends[k].push_back(k0(stage_end(run->points, first_stage + k)));
    hardin.push_back(run->hardin.back());
    count.push_back(breakages(run->points.back()));
  }
  std::vector<double> peak;
  std::vector<double> last;
  for (const Run* run : runs_of(runs, drained)) {
    double largest = 0;
    for (const auto& p : run->points) largest = std::max(largest, p.sin_phi());
    peak.push_back(1 - largest);
    last.push_back(1 - run->points.back().sin_phi());
  }

  Json ends = Json::array();
  for (std::size_t k = 0; k < at_ends.size(); ++k) {
    ends.push_back({{"vertical_stress_Pa", stresses(o)[k]}, {"K0", spread(at_ends[k])}});
    out.lines.push_back("K0 at " + riprap::to_text(in_mpa(stresses(o)[k])) +
                        " MPa: " + spread_text(at_ends[k]));
  }
  out.numbers = {{"K0_at_ends_of_stages", ends},
                 {"jaky_of_peak_sin_phi", spread(peak)},
                 {"jaky_of_last_sin_phi", spread(last)},
                 {"hardin_b_r_at_the_end", spread(hardin)},
                 {"breakages_at_the_end", spread(count)}};
  out.lines.push_back("1 - sin phi of drained shear at 4 MPa: peak " + spread_text(peak) +
                      ", last state " + spread_text(last));
  out.lines.push_back("at the end B_r " + spread_text(hardin) + ", breakages " +
                      spread_text(count));

  riprap::Chart stress_strain =
      chart("Oedometer test", "vertical strain [%]", "vertical stress [MPa]");
  add_curves(stress_strain, runs, oedometer, "", blue, strain, stress);
  riprap::Chart ratio = chart("K0", "vertical stress [MPa]", "sigma_11 / sigma_22 [-]");
  add_curves(ratio, runs, oedometer, "oedometer", blue, stress, k0);
  for (const auto* jaky : {&peak, &last}) {
    const double mean = spread(*jaky)["mean"];
    ratio.series.push_back({jaky == &peak ? "1 - sin phi, peak" : "1 - sin phi, last",
                            {{0, mean}, {in_mpa(stresses(o).back()), mean}},
                            jaky == &peak ? orange : grey,
                            true});
  }
  riprap::Chart crushed = chart("Hardin's relative breakage", "vertical stress [MPa]", "B_r [-]");
  add_curves(crushed, runs, oedometer, "", blue, stress, &Run::hardin);
  riprap::Chart broken = chart("Breakages", "vertical stress [MPa]", "count [-]");
  add_curves(broken, runs, oedometer, "", blue, stress, breakages);
  out.charts = {stress_strain, ratio, crushed, broken};
  return out;
}

}  // namespace paths
