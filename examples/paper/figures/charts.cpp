// SPDX-License-Identifier: BSL-1.0
#include "charts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "../results/samples.hpp"

namespace report {

namespace {

using riprap::Chart;
using riprap::Series;
using riprap::Vec2;

constexpr std::array pressure_colours = {"#472d7b", "#2f6c9e", "#1f9a8a",
                                         "#5cb543", "#d99a00", "#c8352b"};
constexpr auto strain_label = "axial strain [%]";

std::string title_of(Mode mode) {
  return mode == Mode::nb ? "without breakage (NB)" : "with breakage (WB)";
}

// The column at a strain, between two records in proportion.
double value_at(const Run& run, const std::vector<double>& values, double strain) {
  const auto& at = run.column("axial_strain");
  const auto next = std::upper_bound(at.begin(), at.end(), strain);
  if (next == at.begin()) return values.front();
  if (next == at.end()) return values.back();
  const auto i = static_cast<std::size_t>(next - at.begin());
  const double share = (strain - at[i - 1]) / (at[i] - at[i - 1]);
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

struct MeanPoint {
  Vec2 at;
  double deviation = 0;  // standard deviation of the samples; 0 for a single one
};

// Every quarter of a per cent of strain, as far as all samples go.
std::vector<MeanPoint> mean_curve(const std::vector<const Run*>& runs, const std::string& column,
                                  double factor) {
  double end = std::numeric_limits<double>::infinity();
  for (const Run* run : runs) end = std::min(end, run->column("axial_strain").back());
  std::vector<MeanPoint> out;
  if (runs.empty()) return out;
  constexpr double step = 0.0025;
  for (int i = 0; i * step <= end + 1e-3 * step; ++i) {
    std::vector<double> values;
    for (const Run* run : runs)
      values.push_back(factor * value_at(*run, run->column(column), i * step));
    const Estimate e = estimate(values);
    const double deviation = e.samples > 1 ? e.standard_error * std::sqrt(e.samples) : 0;
    // The start is isotropic within the servo's tolerance: a hair below 0 would call for another
    // tick below the axis.
    const bool hair_below = i == 0 && e.mean < 0 && e.mean > -0.02;
    out.push_back({{100 * i * step, hair_below ? 0 : e.mean}, deviation});
  }
  return out;
}

// Adds the mean curve, and a bar at every 2.5 % of strain, shifted a little for every curve so that
// bars of neighbours do not cover each other.
void add_curve(Chart& chart, const Results& results, Mode mode, double pressure,
               const std::string& column, const std::string& name, const std::string& colour,
               bool dashed, double factor = 1) {
  const auto points = mean_curve(results.of(mode, pressure), column, factor);
  if (points.empty()) return;
  Series curve{.name = name, .points = {}, .colour = colour, .dashed = dashed};
  Series bars{.name = "", .points = {}, .colour = colour};
  bars.line = false;
  const std::size_t shift = chart.series.size() / 2 % 6;
  for (std::size_t i = 0; i < points.size(); ++i) {
    curve.points.push_back(points[i].at);
    if (i % 10 != 3 + shift || points[i].deviation == 0) continue;
    bars.points.push_back(points[i].at);
    bars.y_errors.push_back(points[i].deviation);
  }
  chart.series.push_back(curve);
  chart.series.push_back(bars);
}

// Panels beside each other have one scale: each gets the others' extremes, unseen.
void share_scale(std::vector<Chart>& charts) {
  Vec2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
  Vec2 high = -low;
  for (const Chart& chart : charts)
    for (const Series& s : chart.series)
      for (std::size_t i = 0; i < s.points.size(); ++i) {
        const Vec2 bar{0, s.y_errors.empty() ? 0 : s.y_errors[i]};
        low = low.cwiseMin(s.points[i] - bar);
        high = high.cwiseMax(s.points[i] + bar);
      }
  if (!(low.x() <= high.x())) return;
  for (Chart& chart : charts) {
    Series extremes{.name = "", .points = {low, high}};
    extremes.line = false;
    chart.series.push_back(extremes);
  }
}

}  // namespace

std::vector<Chart> pressure_charts(const Results& results, const std::string& column,
                                   const std::string& label, double factor) {
  std::vector<Chart> charts;
  for (const Mode mode : {Mode::nb, Mode::wb}) {
    const std::string letter(1, static_cast<char>('a' + charts.size()));
    Chart chart{"(" + letter + ") " + title_of(mode), strain_label, label, {}};
    for (std::size_t i = 0; i < pressures.size(); ++i)
      add_curve(chart, results, mode, pressures[i], column, pressure_text(pressures[i]),
                pressure_colours[i], false, factor);
    charts.push_back(chart);
  }
  share_scale(charts);
  return charts;
}

std::vector<Chart> anisotropy_charts(const Results& results) {
  std::vector<Chart> charts;
  constexpr std::array<std::array<const char*, 2>, 3> columns{
      {{"a_n", "#c8352b"}, {"a_t", "#2f6c9e"}, {"a", "#3a8a3a"}}};
  for (const double pressure : {0.5e6, 4e6, 14e6}) {
    Chart chart{pressure_text(pressure), strain_label, "anisotropy coefficient", {}};
    for (const auto& [column, colour] : columns)
      for (const Mode mode : {Mode::nb, Mode::wb})
        add_curve(chart, results, mode, pressure, column, column + (", " + to_text(mode)), colour,
                  mode == Mode::wb);
    charts.push_back(chart);
  }
  share_scale(charts);
  return charts;
}

std::vector<Chart> fabric_charts(const Results& results) {
  std::vector<Chart> charts;
  for (const Mode mode : {Mode::nb, Mode::wb}) {
    const std::string letter(1, static_cast<char>('a' + charts.size()));
    Chart chart{"(" + letter + ") " + title_of(mode), strain_label, "sin phi", {}};
    for (const std::size_t i : {std::size_t{0}, pressures.size() - 1}) {
      const std::string at = ", " + pressure_text(pressures[i]);
      add_curve(chart, results, mode, pressures[i], "sin_phi", "eq. 12" + at, pressure_colours[i],
                false);
      add_curve(chart, results, mode, pressures[i], "sin_phi_eq_14", "eq. 14" + at,
                pressure_colours[i], true);
    }
    charts.push_back(chart);
  }
  share_scale(charts);
  return charts;
}

std::vector<Chart> simplified_charts(const Results& results) {
  std::vector<Chart> charts;
  char letter = 'a';
  for (const double pressure : {0.5e6, 14e6}) {
    for (const Mode mode : {Mode::nb, Mode::wb}) {
      Chart chart{std::string("(") + letter + ") " + pressure_text(pressure) + ", " +
                      title_of(mode),
                  strain_label,
                  "sin phi",
                  {}};
      add_curve(chart, results, mode, pressure, "sin_phi", "eq. 12", "#222222", false);
      add_curve(chart, results, mode, pressure, "sin_phi_eq_14", "eq. 14", "#2f6c9e", true);
      add_curve(chart, results, mode, pressure, "sin_phi_eq_15", "eq. 15", "#c8352b", true);
      charts.push_back(chart);
    }
    ++letter;
  }
  share_scale(charts);
  return charts;
}

}  // namespace report
