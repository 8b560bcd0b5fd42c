// SPDX-License-Identifier: BSL-1.0
#include "plot.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "../command_line/number.hpp"
#include "results.hpp"
#include "statistics.hpp"

namespace run_study {

namespace {

using riprap::InvalidInput;

constexpr std::array colours{"#1f6fb4", "#d1495b", "#2e933c", "#8a5fbf",
                             "#c9820a", "#1aa0a0", "#7a5230", "#555555"};
constexpr std::array pale_colours{"#a9c9e6", "#eebac1", "#b1d8b6", "#d2c2e7",
                                  "#ecd3a4", "#a8dede", "#cfbcab", "#bdbdbd"};

std::optional<std::size_t> result_column(const std::string& name) {
  const auto& columns = result_columns();
  const auto found = std::ranges::find(columns, name, &ResultColumn::name);
  if (found == columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns.begin());
}

void require_option(const Study& study, const std::string& name) {
  if (name == "row" || std::ranges::find(study.options, name) != study.options.end()) return;
  throw InvalidInput("--plot: '" + name + "' is neither an option of the table nor a result");
}

double x_of(const FinishedRun& run, const std::string& name) {
  if (const auto column = result_column(name)) return run.results[*column];
  const std::string text = value_of(*run.run, name);
  const auto number = command_line::number_from<double>(text);
  if (!number) throw InvalidInput("--plot: " + name + " = '" + text + "' must be a number for x");
  return *number;
}

void require_place(const riprap::Chart& chart) {
  for (const riprap::Series& s : chart.series)
    for (const riprap::Vec2& p : s.points)
      if (p.x() <= 0)
        throw InvalidInput("--log-x: " + chart.x_label + " = " + riprap::to_text(p.x()) +
                           ": must be above 0 on a logarithmic axis");
}

bool is_shown(const Combination& c, const Plot& plot) {
  return std::ranges::all_of(plot.where, [&](const Against& w) {
    return is_same_value(value_of(c.first(), w.option), w.value);
  });
}

// An option in which two runs differ.
std::string difference(const Run& a, const Run& b) {
  if (a.row != b.row) return "row";
  for (const auto& [option, value] : a.parameters)
    if (option != "seed" && value_of(b, option) != value) return option;
  return "an option";
}

// The shown combinations of a curve in the order of x, each with its x.
using Curve = std::vector<std::pair<double, const Combination*>>;

std::vector<std::pair<std::string, Curve>> curves_of(const Plot& plot,
                                                     const std::vector<Combination>& all) {
  std::vector<std::pair<std::string, Curve>> curves;
  for (const Combination& c : all) {
    if (!is_shown(c, plot)) continue;
    const std::string name = plot.group.empty() ? "" : value_of(c.first(), plot.group);
    auto curve = std::ranges::find(curves, name, &std::pair<std::string, Curve>::first);
    if (curve == curves.end()) curve = curves.insert(curves.end(), {name, {}});
    std::vector<double> x;
    for (const FinishedRun* run : c.runs) x.push_back(x_of(*run, plot.x));
    curve->second.emplace_back(statistics_of(x).mean, &c);
  }
  if (curves.empty()) throw InvalidInput("--plot: no finished run to show");
  for (auto& [name, curve] : curves) {
    std::ranges::stable_sort(curve, {}, &Curve::value_type::first);
    const auto twice = std::ranges::adjacent_find(curve, {}, &Curve::value_type::first);
    if (twice == curve.end() || result_column(plot.x)) continue;
    throw InvalidInput("--plot: several combinations have the same " + plot.x +
                       ", which differ in " +
                       difference(twice->second->first(), std::next(twice)->second->first()) +
                       ": take that as the group, or choose by --where");
  }
  return curves;
}

// "pressure / 1e6", so that the numbers of the axis are short.
void shorten_x(riprap::Chart& chart) {
  double largest = 0;
  for (const riprap::Series& s : chart.series)
    for (const riprap::Vec2& p : s.points) largest = std::max(largest, std::abs(p.x()));
  if (!(largest >= 1e4)) return;
  const int power = 3 * static_cast<int>(std::floor(std::log10(largest) / 3));
  for (riprap::Series& s : chart.series)
    for (riprap::Vec2& p : s.points) p.x() /= std::pow(10, power);
  chart.x_label += " / 1e" + std::to_string(power);
}

}  // namespace

Plot plot_from(const std::string& text, const std::vector<std::string>& where) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == ':')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  if (parts.size() < 2 || parts.size() > 3 || std::ranges::find(parts, "") != parts.end())
    throw InvalidInput("--plot: '" + text + "' is not Y:X or Y:X:GROUP");
  Plot plot{parts[0], parts[1], parts.size() == 3 ? parts[2] : ""};
  for (const std::string& w : where) {
    const std::size_t equals = w.find('=');
    if (equals == w.npos || equals == 0)
      throw InvalidInput("--where: '" + w + "' is not OPTION=VALUE");
    plot.where.push_back({w.substr(0, equals), w.substr(equals + 1)});
  }
  return plot;
}

void check_plot(const Plot& plot, const Study& study) {
  if (!result_column(plot.y))
    throw InvalidInput("--plot: '" + plot.y + "' is not a result of a run, see runs.csv");
  if (!result_column(plot.x)) require_option(study, plot.x);
  if (!plot.group.empty()) require_option(study, plot.group);
  for (const Against& w : plot.where) require_option(study, w.option);
}

riprap::Chart chart_of(const Plot& plot, const Study& study, const std::vector<Combination>& all) {
  check_plot(plot, study);
  const auto y = result_column(plot.y);
  riprap::Chart chart{.title = result_columns()[*y].text,
                      .x_label = plot.x,
                      .y_label = result_columns()[*y].text,
                      .series = {}};
  if (const auto column = result_column(plot.x)) chart.x_label = result_columns()[*column].text;
  std::vector<riprap::Series> means;
  for (const auto& [name, curve] : curves_of(plot, all)) {
    const std::size_t colour = means.size() % colours.size();
    riprap::Series points{.name = "",
                          .points = {},
                          .colour = pale_colours[colour],
                          .mark = riprap::Mark::circle,
                          .line = false};
    const bool speaks_for_itself = plot.group.empty() || plot.group == "row";
    riprap::Series mean{.name = speaks_for_itself ? name : plot.group + " " + name,
                        .points = {},
                        .colour = colours[colour],
                        .mark = riprap::Mark::square,
                        .line = !result_column(plot.x)};
    for (const auto& [x, combination] : curve) {
      for (const FinishedRun* run : combination->runs)
        points.points.emplace_back(x_of(*run, plot.x), run->results[*y]);
      const Statistics s = statistics_of(combination->values(*y));
      mean.points.emplace_back(x, s.mean);
      mean.y_errors.push_back(std::isnan(s.half_interval) ? 0 : s.half_interval);
    }
    chart.series.push_back(std::move(points));
    means.push_back(std::move(mean));
  }
  // Over the points of all curves.
  chart.series.insert(chart.series.end(), means.begin(), means.end());
  if (plot.log_x) {
    require_place(chart);
    chart.x_scale = riprap::AxisScale::logarithmic;
  }
  shorten_x(chart);
  return chart;
}

std::string file_name(const Plot& plot) {
  std::string name = plot.y + "_" + plot.x + (plot.group.empty() ? "" : "_" + plot.group);
  for (const Against& w : plot.where) name += "_" + w.option + "=" + w.value;
  std::ranges::replace(name, '/', '-');
  return name + ".svg";
}

}  // namespace run_study
