// SPDX-License-Identifier: BSL-1.0
// Shear at constant mean stress, of particles that break and of others.

#include <algorithm>

#include <riprap/experiment/paths/shear.hpp>
#include <riprap/experiment/preparation.hpp>

#include "report.hpp"

namespace paths {

namespace {

constexpr double pressure = 4e6;
constexpr auto breakable = "breakable";
constexpr auto unbreakable = "unbreakable";

// What one variant shows, a value for each sample.
struct Shear {
  std::vector<double> peak{};        // sin phi
  std::vector<double> last{};        // sin phi at the end
  std::vector<double> volume{};      // volumetric strain at the end
  std::vector<double> mean_error{};  // of the mean stress
  std::vector<double> rms_error{};
  std::vector<double> hardin{};
};

Shear shear_of(const std::vector<Run>& runs, const char* variant) {
  Shear s;
  for (const Run* run : runs_of(runs, variant)) {
    double largest = 0;
    for (const auto& p : run->points) largest = std::max(largest, p.sin_phi());
    s.peak.push_back(largest);
    s.last.push_back(run->points.back().sin_phi());
    s.volume.push_back(run->points.back().volumetric_strain);
    s.mean_error.push_back(run->stages[first_stage].mean_error);
    s.rms_error.push_back(run->stages[first_stage].rms_error);
    s.hardin.push_back(run->hardin.back());
  }
  return s;
}

}  // namespace

std::vector<PlannedRun> plan_mean_stress(const Options& o) {
  std::vector<PlannedRun> runs;
  for (const char* variant : {breakable, unbreakable}) {
    PlannedRun run{.variant = variant, .pressure = pressure};
    run.sample.breakage = variant == breakable;
    run.stages = riprap::Preparation{}.stages(pressure);
    run.stages.push_back(riprap::constant_mean_stress_shear(
        pressure, {.axial_strain = o.quick ? 0.02 : 0.2, .inertial_number = 8e-4}));
    add_runs(runs, o, run);
  }
  return runs;
}

Findings find_mean_stress(const Options& /*o*/, const std::vector<Run>& runs) {
  const Value strain = [](const auto& p) { return in_per_cent(p.axial_strain); };
  riprap::Chart ratio =
      chart("Constant mean stress, 4 MPa", "axial strain [%]", "(s22 - s11) / (s22 + s11) [-]");
  riprap::Chart volume =
      chart("Volume", "axial strain [%]", "volumetric strain [%], contraction +");
  riprap::Chart stresses = chart("Stresses, first sample", "axial strain [%]", "stress [MPa]");
  riprap::Chart hardin = chart("Hardin's relative breakage", "axial strain [%]", "B_r [-]");
  Findings out;
  for (const char* variant : {breakable, unbreakable}) {
    const char* const colour = variant == breakable ? blue : grey;
    add_curves(ratio, runs, variant, variant, colour, strain,
               [](const auto& p) { return 0.5 * difference(p) / p.stress.mean(); });
    add_curves(volume, runs, variant, variant, colour, strain,
               [](const auto& p) { return in_per_cent(p.volumetric_strain); });
    const Shear s = shear_of(runs, variant);
    out.numbers[variant] = {{"peak_sin_phi", spread(s.peak)},
                            {"last_sin_phi", spread(s.last)},
                            {"last_volumetric_strain", spread(s.volume)},
                            {"mean_stress_mean_error", spread(s.mean_error)},
                            {"mean_stress_rms_error", spread(s.rms_error)},
                            {"hardin_b_r_at_the_end", spread(s.hardin)}};
    out.lines.push_back(std::string(variant) + ": sin phi " + spread_text(s.peak) +
                        " at the peak, " + spread_text(s.last) + " at the end; volumetric strain " +
                        spread_text(s.volume, 100, "%") + "; B_r " + spread_text(s.hardin));
  }
  const Run& first = *runs_of(runs, breakable).front();
  const auto add_stress = [&](const char* name, const char* colour, const Value& value) {
    stresses.series.push_back(curve(first, strain, value, colour));
    stresses.series.back().name = name;
  };
  add_stress("sigma 22", blue, [](const auto& p) { return in_mpa(p.stress.s22); });
  add_stress("sigma 11", orange, [](const auto& p) { return in_mpa(p.stress.s11); });
  add_stress("mean", grey, [](const auto& p) { return in_mpa(p.stress.mean()); });
  add_curves(hardin, runs, breakable, "", blue, strain, &Run::hardin);
  out.charts = {ratio, volume, stresses, hardin};
  return out;
}

}  // namespace paths
