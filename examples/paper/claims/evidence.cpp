// SPDX-License-Identifier: BSL-1.0
#include "evidence.hpp"

#include <cmath>

namespace report {

namespace {

// A series at a pressure, with what it gives to a part.
struct Place {
  std::string series;
  double pressure = 0;
  Cell cell;
};

double level_of_one(std::size_t tests) { return 1 - (1 - test_level) / static_cast<double>(tests); }

Part part_of(const Asked& asked, const std::string& quantity) {
  return {.label = asked.label,
          .quantity = quantity,
          .claimed = asked.claimed,
          .threshold = asked.threshold,
          .margin = asked.margin};
}

std::vector<Place> places_of(const Results& results, const std::vector<Mode>& modes,
                             const std::vector<double>& at, const Feature& feature) {
  std::vector<Place> all;
  for (const Mode mode : modes)
    for (const double pressure : at)
      all.push_back({to_text(mode), pressure, cell(results.of(mode, pressure), feature)});
  return all;
}

void add_finding(Part& part, const Place& place) {
  std::vector<double> numbers;
  for (const auto& [sample, value] : place.cell) numbers.push_back(value);
  const std::string where = pressure_text(place.pressure);
  if (numbers.size() < 2)
    part.missing.push_back(place.series + " at " + where +
                           (numbers.empty() ? " (no sample)" : " (one sample, no scatter)"));
  else
    part.findings.push_back(
        {place.series, where, estimate(numbers), Outcome::within_scatter, false});
}

// Tests the part and, where they may contradict it, its places one by one.
void judge(Part& part, const std::vector<Place>& places, const std::vector<double>& weights,
           bool places_count) {
  std::vector<Cell> cells;
  for (const Place& place : places) {
    add_finding(part, place);
    cells.push_back(place.cell);
  }
  if (!part.missing.empty()) return;
  part.pooled = pooled(cells, weights);
  if (part.pooled.samples < 2) {
    part.missing.push_back("two samples that all series and pressures have");
    return;
  }
  part.shown = shown_by(effect_of(part, part.pooled), part.margin);
  if (!places_count) return;
  for (Finding& f : part.findings) {
    f.counts = true;
    f.outcome = outcome_above_zero(effect_of(part, f.value), level_of_one(places.size()));
    part.contradicted = part.contradicted || f.outcome == Outcome::against;
  }
}

}  // namespace

Estimate effect_of(const Part& part, Estimate value) {
  value.mean -= part.threshold;
  if (part.claimed == Claimed::below) value.mean = -value.mean;
  return value;
}

Cell cell(const std::vector<const Run*>& runs, const Feature& feature) {
  Cell out;
  for (const Run* run : runs)
    if (const double v = feature(*run); !std::isnan(v)) out[run->seed] = v;
  return out;
}

std::vector<double> values(const Results& results, Mode mode, double pressure,
                           const Feature& feature) {
  std::vector<double> out;
  for (const auto& [sample, value] : cell(results.of(mode, pressure), feature))
    out.push_back(value);
  return out;
}

Cell less(const Cell& one, const Cell& other) {
  Cell out;
  for (const auto& [sample, value] : one)
    if (const auto found = other.find(sample); found != other.end())
      out[sample] = value - found->second;
  return out;
}

Part difference_part(const Results& results, const Asked& asked, const std::vector<double>& at,
                     const Feature& feature) {
  Part part = part_of(asked, "mean over the pressures");
  std::vector<Place> places;
  for (const double pressure : at)
    places.push_back({"WB less NB", pressure,
                      less(cell(results.of(Mode::wb, pressure), feature),
                           cell(results.of(Mode::nb, pressure), feature))});
  judge(part, places, mean_weights(places.size()), true);
  return part;
}

Part level_part(const Results& results, const Asked& asked, const std::vector<Mode>& modes,
                const std::vector<double>& at, const Feature& feature) {
  Part part = part_of(asked, "mean");
  judge(part, places_of(results, modes, at, feature), mean_weights(modes.size() * at.size()), true);
  return part;
}

Part contrast_part(const Results& results, const Asked& asked, const std::vector<Mode>& modes,
                   const std::vector<double>& at, const std::vector<double>& weights,
                   const std::string& quantity, const Feature& feature) {
  Part part = part_of(asked, quantity);
  std::vector<double> all;
  for (std::size_t m = 0; m < modes.size(); ++m)
    for (const double w : weights) all.push_back(w / static_cast<double>(modes.size()));
  judge(part, places_of(results, modes, at, feature), all, false);
  return part;
}

Part slope_part(const Results& results, const Asked& asked, const std::vector<Mode>& modes,
                const Feature& feature) {
  std::vector<double> logarithms;
  for (const double pressure : pressures) logarithms.push_back(std::log10(pressure));
  const std::vector<double> at(pressures.begin(), pressures.end());
  Part part = contrast_part(results, asked, modes, at, slope_weights(logarithms),
                            "slope per tenfold pressure", feature);
  // A step per tenfold pressure has the threshold of the slope.
  const double level = level_of_one(modes.size() * (at.size() - 1));
  for (const Mode mode : modes)
    for (std::size_t i = 1; i < at.size(); ++i) {
      const double decades = logarithms[i] - logarithms[i - 1];
      const Estimate step = pooled(
          {cell(results.of(mode, at[i - 1]), feature), cell(results.of(mode, at[i]), feature)},
          {-1 / decades, 1 / decades});
      part.contradicted = part.contradicted ||
                          (step.samples > 1 &&
                           outcome_above_zero(effect_of(part, step), level) == Outcome::against);
    }
  return part;
}

}  // namespace report
