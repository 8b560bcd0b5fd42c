// SPDX-License-Identifier: BSL-1.0
#include "report.hpp"

#include <cmath>
#include <cstdio>
#include <utility>

#include "../study/statistics.hpp"

namespace paths {

namespace {

Json number_or_null(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

}  // namespace

void add_runs(std::vector<PlannedRun>& runs, const Options& o, const PlannedRun& of_all) {
  for (unsigned k = 0; k < o.samples; ++k) {
    PlannedRun run = of_all;
    run.sample.particles = o.particles;
    run.sample.seed = o.seed + k;
    if (k > 0) run.picture.clear();
    runs.push_back(std::move(run));
  }
}

std::vector<const Run*> runs_of(const std::vector<Run>& runs, std::string_view variant) {
  std::vector<const Run*> chosen;
  for (const Run& run : runs)
    if (run.plan.variant == variant) chosen.push_back(&run);
  return chosen;
}

double in_per_cent(double share) { return 100 * share; }
double in_mpa(double stress) { return 1e-6 * stress; }

riprap::Series curve(const Run& run, const Value& x, const Value& y, const std::string& colour) {
  riprap::Series series{"", {}, colour};
  for (const riprap::CurvePoint& p : run.points) series.points.push_back({x(p), y(p)});
  return series;
}

void add_curves(riprap::Chart& chart, const std::vector<Run>& runs, std::string_view variant,
                const std::string& name, const std::string& colour, const Value& x,
                const Value& y) {
  bool first = true;
  for (const Run* run : runs_of(runs, variant)) {
    chart.series.push_back(curve(*run, x, y, colour));
    if (std::exchange(first, false)) chart.series.back().name = name;
  }
}

void add_curves(riprap::Chart& chart, const std::vector<Run>& runs, std::string_view variant,
                const std::string& name, const std::string& colour, const Value& x,
                const std::vector<double> Run::*y) {
  bool first = true;
  for (const Run* run : runs_of(runs, variant)) {
    riprap::Series series{"", {}, colour};
    for (std::size_t i = 0; i < run->points.size(); ++i)
      series.points.push_back({x(run->points[i]), (run->*y)[i]});
    if (std::exchange(first, false)) series.name = name;
    chart.series.push_back(std::move(series));
  }
}

riprap::Chart chart(const std::string& title, const std::string& x, const std::string& y) {
  return {title, x, y, {}};
}

Json spread(const std::vector<double>& values) {
  const run_study::Statistics s = run_study::statistics_of(values);
  Json all = Json::array();
  for (const double value : values) all.push_back(number_or_null(value));
  return {{"mean", number_or_null(s.mean)},
          {"half_of_95_percent_interval", number_or_null(s.half_interval)},
          {"values", all}};
}

std::string spread_text(const std::vector<double>& values, double factor, const std::string& unit) {
  const run_study::Statistics s = run_study::statistics_of(values);
  if (s.count == 0) return "none";
  // Three digits, without an exponent from a thousand on.
  const auto digits = [factor](const char* format, double value) {
    char text[40];
    std::snprintf(text, sizeof text, std::abs(factor * value) < 1000 ? format : "%.0f",
                  factor * value);
    return std::string(text);
  };
  std::string text = digits("%.3g", s.mean);
  if (std::isfinite(s.half_interval)) text += " +- " + digits("%.2g", s.half_interval);
  std::string of;
  if (s.count < values.size())
    of = " (" + std::to_string(s.count) + " of " + std::to_string(values.size()) + ")";
  return text + (unit.empty() ? unit : " " + unit) + of;
}

}  // namespace paths
