// SPDX-License-Identifier: BSL-1.0
#include "evidence.hpp"

#include <cmath>

namespace report {

namespace {

std::string place_of(Mode mode, double pressure) {
  return to_text(mode) + " at " + pressure_text(pressure);
}

Outcome outcome_of(Estimate difference, Claimed claimed) {
  if (claimed == Claimed::below) difference.mean = -difference.mean;
  return outcome_above_zero(difference);
}

std::string missing_text(const std::string& what, std::size_t samples) {
  return what + (samples == 0 ? " (no sample)" : " (one sample, no scatter)");
}

}  // namespace

void Evidence::add(const Evidence& other) {
  findings.insert(findings.end(), other.findings.begin(), other.findings.end());
  missing.insert(missing.end(), other.missing.begin(), other.missing.end());
}

Evidence Evidence::labelled(const std::string& text) const {
  Evidence out = *this;
  for (Finding& f : out.findings) f.series += ", " + text;
  return out;
}

Evidence Evidence::unless_against() const {
  Evidence out = *this;
  for (Finding& f : out.findings)
    if (f.outcome == Outcome::within_scatter) f.outcome = Outcome::agrees;
  return out;
}

std::vector<double> values(const Results& results, Mode mode, double pressure,
                           const Feature& feature) {
  std::vector<double> out;
  for (const Run* run : results.of(mode, pressure))
    if (const double v = feature(*run); !std::isnan(v)) out.push_back(v);
  return out;
}

std::vector<double> paired(const Results& results, Mode mode, double pressure, Mode less_mode,
                           double less_pressure, const Feature& feature) {
  std::vector<double> out;
  for (const Run* run : results.of(mode, pressure))
    for (const Run* less : results.of(less_mode, less_pressure)) {
      const double difference =
          run->seed == less->seed ? feature(*run) - feature(*less) : std::nan("");
      if (!std::isnan(difference)) out.push_back(difference);
    }
  return out;
}

Evidence differences(const Results& results, Mode mode, Mode less, const std::vector<double>& at,
                     const Feature& feature, Claimed claimed) {
  Evidence out;
  for (const double pressure : at) {
    const std::vector<double> all = paired(results, mode, pressure, less, pressure, feature);
    const std::string series = to_text(mode) + " less " + to_text(less);
    if (all.size() < 2) {
      out.missing.push_back(missing_text(series + " at " + pressure_text(pressure), all.size()));
      continue;
    }
    const Estimate difference = estimate(all);
    out.findings.push_back(
        {series, pressure_text(pressure), difference, outcome_of(difference, claimed)});
  }
  return out;
}

Evidence levels(const Results& results, const std::vector<Mode>& modes,
                const std::vector<double>& at, const Feature& feature, Claimed claimed,
                double chance) {
  Evidence out;
  for (const Mode mode : modes)
    for (const double pressure : at) {
      const std::vector<double> all = values(results, mode, pressure, feature);
      if (all.size() < 2) {
        out.missing.push_back(missing_text(place_of(mode, pressure), all.size()));
        continue;
      }
      const Estimate value = estimate(all);
      Estimate over = value;
      over.mean -= chance;
      out.findings.push_back(
          {to_text(mode), pressure_text(pressure), value, outcome_of(over, claimed)});
    }
  return out;
}

Evidence mean_levels(const Results& results, const std::vector<Mode>& modes,
                     const std::vector<double>& at, const Feature& feature, Claimed claimed,
                     double tolerance) {
  Evidence out = levels(results, modes, at, feature, claimed);
  for (Finding& f : out.findings) {
    const bool agrees =
        claimed == Claimed::above ? f.value.mean >= tolerance : f.value.mean <= tolerance;
    f.outcome = agrees ? Outcome::agrees : Outcome::against;
  }
  return out;
}

Evidence trend_with_pressure(const Results& results, const std::vector<Mode>& modes,
                             const Feature& feature, Claimed claimed) {
  Evidence out;
  for (const Mode mode : modes) {
    Evidence shown =
        levels(results, {mode}, {pressures.begin(), pressures.end()}, feature, claimed);
    for (Finding& f : shown.findings) f.counts = false;
    const bool complete = shown.missing.empty();
    out.add(shown);
    if (!complete) continue;
    const auto change = [&](double from, double to) {
      return estimate(paired(results, mode, to, mode, from, feature));
    };
    const Estimate whole = change(pressures.front(), pressures.back());
    if (whole.samples < 2) {
      out.missing.push_back(to_text(mode) +
                            ": the same samples at the lowest and highest pressure");
      continue;
    }
    Outcome outcome = outcome_of(whole, claimed);
    for (std::size_t i = 1; i < pressures.size(); ++i) {
      const Estimate step = change(pressures[i - 1], pressures[i]);
      if (outcome == Outcome::agrees && step.samples > 1 &&
          outcome_of(step, claimed) == Outcome::against)
        outcome = Outcome::within_scatter;
    }
    out.findings.push_back(
        {to_text(mode), pressure_text(pressures.front()) + " to " + pressure_text(pressures.back()),
         whole, outcome});
  }
  return out;
}

}  // namespace report
