// SPDX-License-Identifier: BSL-1.0
// A path that a file describes: how the sample stands at the end of each stage.

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>

#include <riprap/core/errors.hpp>
#include <riprap/experiment/read_path.hpp>

#include "report.hpp"

namespace paths {

namespace {

// What all samples have at the end of a stage; not-a-number where a sample recorded nothing in it.
std::vector<double> at_end(const std::vector<Run>& runs, std::size_t stage, const Value& value) {
  std::vector<double> all;
  for (const Run& run : runs) {
    const Points points = stage_points(run.points, stage);
    all.push_back(points.empty() ? std::numeric_limits<double>::quiet_NaN() : value(points.back()));
  }
  return all;
}

double breakages(const riprap::CurvePoint& p) { return static_cast<double>(p.breakages); }

void report_stage(Findings& out, const std::vector<Run>& runs, std::size_t stage) {
  const std::string& name = runs.front().plan.stages[stage].name;
  const auto at = [&](const Value& value) { return at_end(runs, stage, value); };
  const auto axial = at([](const auto& p) { return p.axial_strain; });
  const auto s11 = at([](const auto& p) { return p.stress.s11; });
  const auto s22 = at([](const auto& p) { return p.stress.s22; });
  const auto reached = std::count_if(runs.begin(), runs.end(), [stage](const Run& run) {
    return run.stages[stage].reached_target;
  });
  out.numbers["ends_of_stages"].push_back(
      {{"name", name},
       {"axial_strain", spread(axial)},
       {"volumetric_strain", spread(at([](const auto& p) { return p.volumetric_strain; }))},
       {"sigma_11_Pa", spread(s11)},
       {"sigma_22_Pa", spread(s22)},
       {"porosity", spread(at([](const auto& p) { return p.porosity; }))},
       {"breakages", spread(at(breakages))},
       {"reached_target", reached}});
  out.lines.push_back(name + ": axial strain " + spread_text(axial, 100, "%") + ", sigma_11 " +
                      spread_text(s11, 1e-6) + ", sigma_22 " + spread_text(s22, 1e-6, "MPa") +
                      ", breakages " + spread_text(at(breakages)));
  if (const auto missed = static_cast<std::ptrdiff_t>(runs.size()) - reached; missed > 0)
    out.lines.back() += "; target missed in " + std::to_string(missed) + " of " +
                        std::to_string(runs.size()) + " samples";
}

}  // namespace

std::vector<PlannedRun> plan_from_file(const Options& o) {
  const std::filesystem::path file =
      o.resume.empty() ? std::filesystem::path(o.test) : o.path_copy();
  auto path = riprap::read_path(file);
  PlannedRun run{.variant = o.path_name(), .pressure = path.confining_pressure};
  run.stages = std::move(path.stages);
  run.picture = "After " + run.variant;
  std::vector<PlannedRun> runs;
  add_runs(runs, o, run);
  try {
    check_path(runs.front());
  } catch (const riprap::InvalidInput& error) {
    throw riprap::InvalidInput(file.string() + ": " + error.what());
  }
  return runs;
}

Findings find_from_file(const Options& /*o*/, const std::vector<Run>& runs) {
  Findings out;
  out.numbers["ends_of_stages"] = Json::array();
  const auto& stages = runs.front().plan.stages;
  for (std::size_t k = 0; k < stages.size(); ++k)
    if (stages[k].records) report_stage(out, runs, k);

  const Value strain = [](const auto& p) { return in_per_cent(p.axial_strain); };
  riprap::Chart stresses = chart("Stresses, first sample", "axial strain [%]", "stress [MPa]");
  const auto add_stress = [&](const char* name, const char* colour, const Value& value) {
    stresses.series.push_back(curve(runs.front(), strain, value, colour));
    stresses.series.back().name = name;
  };
  add_stress("sigma 22", blue, [](const auto& p) { return in_mpa(p.stress.s22); });
  add_stress("sigma 11", orange, [](const auto& p) { return in_mpa(p.stress.s11); });
  riprap::Chart volume =
      chart("Volume", "axial strain [%]", "volumetric strain [%], contraction +");
  riprap::Chart path = chart("Stress path", "(s11 + s22) / 2 [MPa]", "(s22 - s11) / 2 [MPa]");
  riprap::Chart broken = chart("Breakages", "axial strain [%]", "count [-]");
  for (std::size_t k = runs.size(); k-- > 0;) {
    const Run& run = runs[k];
    const char* const colour = k == 0 ? blue : "#b9cfe4";
    volume.series.push_back(curve(
        run, strain, [](const auto& p) { return in_per_cent(p.volumetric_strain); }, colour));
    path.series.push_back(curve(
        run, [](const auto& p) { return in_mpa(p.stress.mean()); },
        [](const auto& p) { return in_mpa(0.5 * difference(p)); }, colour));
    broken.series.push_back(curve(run, strain, breakages, colour));
  }
  out.charts = {stresses, volume, path, broken};
  return out;
}

}  // namespace paths
