// SPDX-License-Identifier: BSL-1.0
#include "results.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include <riprap/core/errors.hpp>

namespace run_study {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// What comes from summary.json, in the order of the columns; then what is made of the tables.
struct FromSummary {
  ResultColumn column;
  const char* pointer;
};
const std::vector<FromSummary> from_summary{
    {{"peak_sin_phi", "peak sin φ"}, "/peak/sin_phi"},
    {{"strain_at_peak", "axial strain at the peak"}, "/peak/axial_strain"},
    {{"volumetric_strain_at_peak", "volumetric strain at the peak"}, "/peak/volumetric_strain"},
    {{"end_sin_phi", "sin φ at the end"}, "/end/sin_phi"},
    {{"end_volumetric_strain", "volumetric strain at the end", "volume %", "%.1f", 100},
     "/end/volumetric_strain"},
    {{"end_coordination_number", "coordination number at the end"}, "/end/coordination_number"},
    {{"end_contacts_per_particle", "contacts per particle at the end", "2M/N", "%.2f", 2},
     "/end/contacts_per_particle"},
    {{"end_porosity", "porosity at the end"}, "/end/porosity"},
    {{"breakages", "breakages", "breakages", "%.0f"}, "/counts/breakages"},
    {{"breakages_before_shear", "breakages before shear"}, "/counts/breakages_before_shear"},
    {{"hardin_b_r", "Hardin's B_r", "B_r", "%.3f"}, "/grading_before_and_after/hardin_b_r"},
    {{"marsal_b_g", "Marsal's B_g"}, "/grading_before_and_after/marsal_b_g"},
    {{"lade_b_10", "Lade's B_10"}, "/grading_before_and_after/lade_b_10"},
    {{"einav_b_r", "Einav's B_r"}, "/grading_before_and_after/einav_b_r"},
    {{"dust_share", "dust over rock"}, "/grading_before_and_after/dust_share"},
    {{"overlap_ratio_largest", "largest overlap over mean diameter"},
     "/numbers/overlap_ratio_largest"},
    {{"kappa", "stiffness level κ"}, "/numbers/kappa"},
    {{"energy_error", "error of the energy balance"}, "/energy_error"},
};
const std::vector<ResultColumn> from_tables{
    {"smoothed_peak_sin_phi", "peak sin φ, mean over 2 % of strain", "peak sin φ", "%.3f"},
    {"residual_sin_phi", "sin φ, mean over the last quarter of the strain", "residual", "%.3f"},
    {"law_share", "energy of the contact law over boundary work", "law %", "%.2f", 100},
    {"splitting_share", "energy of breaks over boundary work", "splitting %", "%.2f", 100},
    {"damping_share", "energy of damping over boundary work", "damping %", "%.1f", 100},
    {"end_overlap_ratio", "overlap over mean diameter at the end", "overlap %", "%.2f", 100},
    {"checks_broken", "checks that do not hold"},
    {"steps", "steps"},
    {"wall_s", "wall time [s]"},
    {"step_wall_s", "wall time of a step [s]", "step µs", "%.0f", 1e6},
};

std::string text_of(const fs::path& file) {
  std::ifstream input(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(input), {}};
}

double number_at(const Json& summary, const char* pointer) {
  const Json::json_pointer at(pointer);
  if (!summary.contains(at) || !summary[at].is_number()) return none;
  return summary[at].get<double>();
}

double sum_of(const Json& rows, const char* name) {
  double sum = 0;
  for (const Json& row : rows) sum += row.value(name, 0.0);
  return sum;
}

double checks_broken(const Json& summary) {
  if (!summary.contains("checks")) return none;
  return static_cast<double>(std::ranges::count_if(
      summary["checks"], [](const Json& check) { return !check.value("holds", true); }));
}

void add_from_tables(const fs::path& folder, const Json& summary, std::vector<double>& values) {
  const NumberTable curve = NumberTable::from_csv(text_of(folder / "curve.csv"));
  const NumberTable energy = NumberTable::from_csv(text_of(folder / "energy.csv"));
  const bool has_curve = !curve.rows.empty() && !energy.rows.empty();
  if (has_curve) {
    const std::vector<double> strains = curve.column("axial_strain");
    const std::vector<double> sin_phi = curve.column("sin_phi");
    values.push_back(smoothed_peak(strains, sin_phi));
    values.push_back(mean_of_last_quarter(strains, sin_phi));
    const double work = energy.column("boundary_work").back();
    for (const char* part : {"law_residual", "breakage", "damping"})
      values.push_back(energy.column(part).back() / work);
    values.push_back(curve.column("overlap_ratio").back());
  } else {
    values.insert(values.end(), 6, none);
  }
  const Json stages = summary.value("stages", Json::array());
  const double steps = sum_of(stages, "steps");
  const double seconds = sum_of(stages, "wall_s");
  values.insert(values.end(),
                {checks_broken(summary), steps, seconds, steps > 0 ? seconds / steps : none});
}

template <class Use>
void for_each_cell(const std::string& line, Use&& use) {
  std::istringstream cells(line);
  std::string cell;
  while (std::getline(cells, cell, ',')) use(cell);
}

}  // namespace

const std::vector<ResultColumn>& result_columns() {
  static const std::vector<ResultColumn> columns = [] {
    std::vector<ResultColumn> all;
    for (const FromSummary& f : from_summary) all.push_back(f.column);
    all.insert(all.end(), from_tables.begin(), from_tables.end());
    return all;
  }();
  return columns;
}

std::vector<double> results_in(const fs::path& folder) {
  const Json summary = Json::parse(text_of(folder / "summary.json"), nullptr, false);
  if (!summary.is_object())
    throw riprap::SimulationError((folder / "summary.json").string() + " cannot be read");
  std::vector<double> values;
  for (const FromSummary& f : from_summary) values.push_back(number_at(summary, f.pointer));
  add_from_tables(folder, summary, values);
  return values;
}

NumberTable NumberTable::from_csv(const std::string& text) {
  NumberTable table;
  std::istringstream lines(text);
  std::string line;
  if (std::getline(lines, line))
    for_each_cell(line, [&](const std::string& cell) { table.names.push_back(cell); });
  while (std::getline(lines, line)) {
    table.rows.emplace_back();
    for_each_cell(line, [&](const std::string& cell) {
      char* end = nullptr;
      const double value = std::strtod(cell.c_str(), &end);
      table.rows.back().push_back(end == cell.c_str() ? none : value);
    });
    table.rows.back().resize(table.names.size(), none);
  }
  return table;
}

std::vector<double> NumberTable::column(const std::string& name) const {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) throw riprap::SimulationError("a table has no column " + name);
  std::vector<double> values;
  for (const std::vector<double>& row : rows)
    values.push_back(row[static_cast<std::size_t>(found - names.begin())]);
  return values;
}

namespace {

// Over the points between two strains, with room for round-off of the strains.
double mean_between(const std::vector<double>& strains, const std::vector<double>& values,
                    double from, double to) {
  double sum = 0;
  double count = 0;
  for (std::size_t i = 0; i < strains.size(); ++i)
    if (strains[i] >= from - 1e-4 && strains[i] <= to + 1e-4) {
      sum += values[i];
      ++count;
    }
  return sum / count;
}

}  // namespace

double smoothed_peak(const std::vector<double>& strains, const std::vector<double>& values) {
  double peak = 0;
  for (const double strain : strains)
    peak = std::max(peak, mean_between(strains, values, strain - 0.01, strain + 0.01));
  return peak;
}

double mean_of_last_quarter(const std::vector<double>& strains, const std::vector<double>& values) {
  return mean_between(strains, values, 0.75 * strains.back(), strains.back());
}

}  // namespace run_study
