// SPDX-License-Identifier: BSL-1.0
#include "report.hpp"

#include <cstdio>
#include <functional>
#include <map>

#include <riprap/output/chart.hpp>

#include "../shear_tests/results.hpp"
#include "../study/statistics.hpp"

namespace rivals {

namespace {

using riprap::Chart;
using riprap::Series;
using riprap::Vec2;

// Columns of a curve, in the order of `run_model`.
enum Column { axial_strain, sin_phi, volumetric_strain, coordination, breakages };

// The mean of a column over the samples, against axial strain in per cent.
Series curve(const ModelRuns& runs, Column column, double factor) {
  std::vector<std::vector<Vec2>> curves;
  for (const Json& sample : runs.samples) {
    std::vector<Vec2>& points = curves.emplace_back();
    for (const Json& row : sample["curve"])
      points.push_back({100 * row[axial_strain].get<double>(), factor * row[column].get<double>()});
  }
  return {runs.model->title, shear_tests::mean_curve(curves), runs.model->colour};
}

// Mean sizes at given shares of the mass, at the end.
Series grading(const ModelRuns& runs) {
  std::vector<std::vector<Vec2>> curves;
  for (const Json& sample : runs.samples) {
    std::vector<Vec2>& points = curves.emplace_back();
    for (const Json& row : sample["grading"])
      points.push_back({1e3 * row[0].get<double>(), 100 * row[1].get<double>()});
  }
  return {runs.model->title, shear_tests::mean_curve(curves), runs.model->colour};
}

std::string interval(const ModelRuns& runs, const char* key, double factor, int decimals) {
  std::vector<double> values;
  for (const Json& sample : runs.samples) values.push_back(factor * sample[key].get<double>());
  return shear_tests::interval_text(run_study::statistics_of(values), decimals);
}

}  // namespace

riprap::Svg charts(const std::vector<ModelRuns>& runs) {
  struct Quantity {
    const char* title;
    const char* label;
    Column column;
    double factor;
  };
  constexpr Quantity quantities[] = {{"Mobilised friction", "sin phi [-]", sin_phi, 1},
                                     {"Volume", "contraction [%]", volumetric_strain, 100},
                                     {"Coordination", "contacts per particle [-]", coordination, 1},
                                     {"Breakages in shear", "[-]", breakages, 1}};
  std::map<double, std::vector<const ModelRuns*>> by_pressure;
  for (const ModelRuns& one : runs) by_pressure[one.pressure].push_back(&one);
  std::vector<Chart> all;
  const auto title = [](const char* what, double pressure) {
    return what + (", " + riprap::to_text(1e-6 * pressure) + " MPa");
  };
  for (const Quantity& q : quantities)
    for (const auto& [pressure, of_pressure] : by_pressure) {
      Chart chart{title(q.title, pressure), "axial strain [%]", q.label, {}};
      for (const ModelRuns* one : of_pressure)
        chart.series.push_back(curve(*one, q.column, q.factor));
      all.push_back(std::move(chart));
    }
  for (const auto& [pressure, of_pressure] : by_pressure) {
    Chart chart{title("Grading", pressure), "size [mm]", "finer by area [%]", {}};
    chart.x_scale = riprap::AxisScale::logarithmic;
    for (const ModelRuns* one : of_pressure) chart.series.push_back(grading(*one));
    all.push_back(std::move(chart));
  }
  return riprap::chart_sheet(all);
}

std::string table(const std::vector<ModelRuns>& runs) {
  std::string text =
      "| confining pressure | model | peak sin phi | contraction at the end [%] | breakages before "
      "shear | in shear | Hardin's B_r | processor time [s] | per step [us] |\n"
      "|---|---|---|---|---|---|---|---|---|\n";
  for (const ModelRuns& one : runs) {
    std::vector<double> contraction;
    std::vector<double> broken;
    std::vector<double> per_step;
    for (const Json& sample : one.samples) {
      contraction.push_back(100 * sample["curve"].back()[volumetric_strain].get<double>());
      broken.push_back(sample["curve"].back()[breakages].get<double>());
      per_step.push_back(1e6 * sample["seconds"].get<double>() / sample["steps"].get<double>());
    }
    const auto of = [](const std::vector<double>& values, int decimals) {
      return shear_tests::interval_text(run_study::statistics_of(values), decimals);
    };
    text += "| " + riprap::to_text(1e-6 * one.pressure) + " MPa | " + one.model->title + " | " +
            interval(one, "peak_sin_phi", 1, 3) + " | " + of(contraction, 2) + " | " +
            interval(one, "breakages_before_shear", 1, 1) + " | " + of(broken, 1) + " | " +
            interval(one, "hardin_breakage", 1, 4) + " | " + interval(one, "seconds", 1, 1) +
            " | " + of(per_step, 0) + " |\n";
  }
  return text;
}

}  // namespace rivals
