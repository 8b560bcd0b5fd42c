// SPDX-License-Identifier: BSL-1.0
#include "requirements.hpp"

#include <cmath>
#include <cstdio>
#include <functional>

#include "../results/curve_features.hpp"
#include "evidence.hpp"

namespace report {

namespace {

std::string number(double value, int decimals) {
  char buffer[48];
  std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value + 0.0);
  return buffer;
}

// Not a number without a sample.
double mean(const Results& results, Mode mode, double pressure, const Feature& feature) {
  return estimate(values(results, mode, pressure, feature)).mean;
}

Met met(bool all, bool judged) { return !judged ? Met::not_judged : all ? Met::yes : Met::no; }

Requirement friction_falls(const Results& results) {
  const Feature peak = [](const Run& run) { return smooth_peak(run, "sin_phi").value; };
  const double low = mean(results, Mode::nb, 0.5e6, peak);
  const double high = mean(results, Mode::nb, 14e6, peak);
  return {
      "Without breakage the largest sin phi, averaged over 2 % of strain, falls by at least 0.03 "
      "from 0.5 to 14 MPa.",
      number(low, 3) + " to " + number(high, 3) + ", a fall of " + number(low - high, 3),
      met(low - high >= 0.03, !std::isnan(low - high))};
}

// With breakage more than without at 8 and 14 MPa.
Requirement more_with_breakage(const Results& results, const std::string& text,
                               const Feature& feature, int decimals) {
  bool all = true;
  bool judged = true;
  std::string numbers;
  for (const double pressure : {8e6, 14e6}) {
    const double with = mean(results, Mode::wb, pressure, feature);
    const double without = mean(results, Mode::nb, pressure, feature);
    judged = judged && !std::isnan(with - without);
    all = all && with > without;
    numbers += (numbers.empty() ? "" : "; ") + pressure_text(pressure) + ": " +
               number(with, decimals) + " with, " + number(without, decimals) + " without";
  }
  return {text, numbers, met(all, judged)};
}

double gap(const Run& run, const char* prediction) { return mean_gap(run, prediction); }

Requirement eq_14_in_the_mean(const Results& results) {
  double by_14 = 0;
  double by_15 = 0;
  double count = 0;
  for (const Run& run : results.runs) {
    by_14 += gap(run, "sin_phi_eq_14");
    by_15 += gap(run, "sin_phi_eq_15");
    ++count;
  }
  return {"Eq. 14 is closer to eq. 12 than eq. 15 is, in the mean of all runs with and without "
          "breakage.",
          "mean distance " + number(by_14 / count, 3) + " against " + number(by_15 / count, 3),
          met((by_14 < by_15), count > 0)};
}

Requirement eq_14_everywhere(const Results& results, Mode mode) {
  bool judged = true;
  bool all = true;
  std::string numbers;
  for (const double pressure : pressures) {
    const auto of = [&](const char* prediction) {
      return mean(results, mode, pressure, [&](const Run& run) { return gap(run, prediction); });
    };
    const double by_14 = of("sin_phi_eq_14");
    const double by_15 = of("sin_phi_eq_15");
    judged = judged && !std::isnan(by_14 - by_15);
    all = all && by_14 < by_15;
    numbers += (numbers.empty() ? "" : "; ") + pressure_text(pressure) + ": " + number(by_14, 3) +
               " against " + number(by_15, 3);
  }
  const std::string with = mode == Mode::nb ? "without" : "with";
  return {"The same at every single pressure, " + with + " breakage.", numbers, met(all, judged)};
}

}  // namespace

std::vector<Requirement> requirements(const Results& results) {
  return {friction_falls(results),
          more_with_breakage(
              results,
              "With breakage the sample contracts more at 8 and 14 MPa (volumetric strain [%] over "
              "the last 5 % of strain, contraction positive).",
              [](const Run& run) { return 100 * at_end(run, "volumetric_strain"); }, 1),
          more_with_breakage(
              results,
              "With breakage the coordination number (2M/N, over the last 5 % of strain) is higher "
              "at 8 and 14 MPa.",
              [](const Run& run) { return at_end(run, "coordination_number"); }, 2),
          eq_14_in_the_mean(results),
          eq_14_everywhere(results, Mode::nb),
          eq_14_everywhere(results, Mode::wb)};
}

Table requirements_table(const std::vector<Requirement>& all) {
  Table table{{"outcome", "measured", ""}, {}};
  for (const Requirement& r : all)
    table.rows.push_back({r.text, r.numbers,
                          r.met == Met::yes  ? "**holds**"
                          : r.met == Met::no ? "**does not hold**"
                                             : "not judged: runs are missing"});
  return table;
}

}  // namespace report
