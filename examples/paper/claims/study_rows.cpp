// SPDX-License-Identifier: BSL-1.0
#include "study_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "../results/curve_features.hpp"
#include "claims.hpp"

namespace report {

namespace {

struct Row {
  const char* variation;
  const char* text;
};

// In the order in which they are shown.
constexpr std::array rows{
    Row{"mean_tension_line", "crack across the mean tension of the failed elements"},
    Row{"failure_plane",
        "crack along the failure plane of the first element, through the centroid"},
    Row{"small_pieces",
        "pieces down to 2 % of the mean area and of aspect 5, instead of 8 % and 3"},
    Row{"weak_rock", "rock of a quarter of the strength"},
    Row{"two_pinned_contacts", "two contacts pinned in the stress analysis"},
    Row{"paper_preset", "`presets::bagherzadeh_2008()`: chord contacts and two contacts pinned"},
    Row{"recommended_preset",
        "`presets::recommended()`: six-node triangles, calibrated limit, mean-tension line"},
    Row{"periodic_cell", "periodic cell: no ring, so that every particle may break"},
    Row{"blunt_particles", "blunt particles: 5 to 8 vertices instead of 3 to 5"},
    Row{"stocky_pieces", "stocky pieces: an aspect of 2 at most instead of 3"},
    Row{"large_pieces", "large pieces: 16 % of the mean area at least instead of 8 %"},
    Row{"slow_shear", "half the rate of strain"},
    Row{"stiff_contacts", "contacts four times stiffer"},
    Row{"many_particles", "ten times as many particles"}};

struct Column {
  const char* name;
  int decimals;
  Feature feature;
};

const std::vector<Column>& columns() {
  const auto in_shear = [](const char* column) {
    return [column](const Run& r) { return mean_between(r, column, 0.01, 1); };
  };
  const auto gap = [](const char* column) {
    return [column](const Run& r) { return mean_gap(r, column); };
  };
  static const std::vector<Column> all{
      {"peak sin phi", 3, [](const Run& r) { return smooth_peak(r, "sin_phi").value; }},
      {"sin phi at the end", 3, [](const Run& r) { return at_end(r, "sin_phi"); }},
      {"volumetric strain [%]", 2,
       [](const Run& r) { return 100 * at_end(r, "volumetric_strain"); }},
      {"2M/N", 2, [](const Run& r) { return at_end(r, "coordination_number"); }},
      {"breakages", 0, [](const Run& r) { return static_cast<double>(r.breaks.size()); }},
      {"a", 3, in_shear("a")},
      {"a_n", 3, in_shear("a_n")},
      {"a_t", 3, in_shear("a_t")},
      {"gap of eq. 14", 3, gap("sin_phi_eq_14")},
      {"gap of eq. 15", 3, gap("sin_phi_eq_15")}};
  return all;
}

std::string number(double value, int decimals, const char* sign = "") {
  char buffer[48];
  const std::string format = std::string("%") + sign + ".*f";
  std::snprintf(buffer, sizeof buffer, format.c_str(), decimals, value + 0.0);
  return buffer;
}

Table table_with(const std::vector<std::string>& first) {
  Table table{first, {}};
  for (const Column& c : columns()) table.head.push_back(c.name);
  return table;
}

// Calls visit(row, mode, pressure, its runs, runs of the series) for every row that has runs.
template <class Visit>
void for_each_row(const Results& results, Visit visit) {
  for (const Row& row : rows)
    for (const Mode mode : both_series())
      for (const double pressure : pressures) {
        const auto runs = results.of_row(row.variation, mode, pressure);
        if (!runs.empty()) visit(row, mode, pressure, runs, results.of(mode, pressure));
      }
}

void add_means(Table& table, const std::string& place, const std::string& text,
               const std::vector<const Run*>& runs) {
  table.rows.push_back({place, text, std::to_string(runs.size())});
  for (const Column& c : columns()) {
    std::vector<double> numbers;
    for (const auto& [sample, value] : cell(runs, c.feature)) numbers.push_back(value);
    table.rows.back().push_back(numbers.empty() ? "" : number(estimate(numbers).mean, c.decimals));
  }
}

std::string change_text(const Cell& changes, int decimals) {
  std::vector<double> numbers;
  for (const auto& [sample, value] : changes) numbers.push_back(value);
  if (numbers.empty()) return "";
  const Estimate e = estimate(numbers);
  const std::string mean = number(e.mean, decimals, "+");
  if (e.samples < 2) return mean;
  const std::string text = mean + " ± " + number(e.standard_error, decimals);
  const bool is_clear = outcome_above_zero(e, 0.975) != Outcome::within_scatter;
  return is_clear ? "**" + text + "**" : text;
}

double peak(const Run& run) { return smooth_peak(run, "sin_phi").value; }

// Of the largest sin phi over the logarithm of pressure, at the pressures of the stiff runs.
Estimate slope(const Results& results, const std::string& variation, Mode mode,
               const std::vector<double>& at) {
  std::vector<double> logarithms;
  std::vector<Cell> cells;
  for (const double pressure : at) {
    logarithms.push_back(std::log10(pressure));
    cells.push_back(cell(results.of_row(variation, mode, pressure), peak));
  }
  return pooled(cells, slope_weights(logarithms));
}

}  // namespace

Table rows_table(const Results& results) {
  Table table = table_with({"series", "changed", "samples"});
  // Series that rows belong to come first.
  for (const Mode mode : both_series())
    for (const double pressure : pressures) {
      bool has_row = false;
      for_each_row(results, [&](const Row&, Mode m, double p, const auto&, const auto&) {
        has_row = has_row || (m == mode && p == pressure);
      });
      const auto series = results.of(mode, pressure);
      if (has_row && !series.empty())
        add_means(table, to_text(mode) + ", " + pressure_text(pressure), "nothing", series);
    }
  const bool empty = table.rows.empty();
  for_each_row(results,
               [&](const Row& row, Mode mode, double pressure, const auto& runs, const auto&) {
                 add_means(table, to_text(mode) + ", " + pressure_text(pressure), row.text, runs);
               });
  if (empty) table.rows.clear();
  return table;
}

Table row_changes_table(const Results& results) {
  Table table = table_with({"series", "changed"});
  for_each_row(results, [&](const Row& row, Mode mode, double pressure, const auto& runs,
                            const auto& series) {
    table.rows.push_back({to_text(mode) + ", " + pressure_text(pressure), row.text});
    for (const Column& c : columns())
      table.rows.back().push_back(
          change_text(less(cell(runs, c.feature), cell(series, c.feature)), c.decimals));
  });
  return table;
}

std::string softness_text(const Results& results) {
  std::vector<double> at;
  for (const double pressure : pressures)
    if (!results.of_row("stiff_contacts", Mode::nb, pressure).empty()) at.push_back(pressure);
  if (at.size() < 2) return "";
  const Estimate wb = slope(results, "", Mode::wb, at);
  const Estimate nb = slope(results, "", Mode::nb, at);
  const Estimate stiff = slope(results, "stiff_contacts", Mode::nb, at);
  if (std::min({wb.samples, nb.samples, stiff.samples}) < 2) return "";
  std::string places;
  for (const double pressure : at)
    places += (places.empty()          ? ""
               : pressure == at.back() ? " and "
                                       : ", ") +
              pressure_text(pressure);
  return "How much of the fall of strength with pressure is contact softness and not breakage: "
         "over " +
         places + " the largest sin phi changes with each tenfold pressure by " + number_text(wb) +
         " with breakage, by " + number_text(nb) + " without, which is " +
         number(100 * nb.mean / wb.mean, 0) + " % of it, and by " + number_text(stiff) +
         " without breakage and with contacts four times stiffer.";
}

}  // namespace report
