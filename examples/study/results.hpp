// SPDX-License-Identifier: BSL-1.0
#pragma once
// The numbers that a finished run has left, as one row of a table.

#include <filesystem>
#include <string>
#include <vector>

namespace run_study {

// Of runs.csv: name, what it is in words for the axis of a plot, and how a table of means has it.
struct ResultColumn {
  const char* name;
  const char* text;
  const char* title = nullptr;  // in table.md; or not in it
  const char* format = "%.3g";
  double unit = 1;
};
const std::vector<ResultColumn>& result_columns();

// One value a column; not-a-number for what the run has not. Throws riprap::SimulationError for a
// folder without a summary.json that can be read.
std::vector<double> results_in(const std::filesystem::path& folder);

// Columns of a file of numbers, one header line.
struct NumberTable {
  std::vector<std::string> names{};
  std::vector<std::vector<double>> rows{};

  static NumberTable from_csv(const std::string& text);
  // Throws riprap::SimulationError if there is no such column.
  [[nodiscard]] std::vector<double> column(const std::string& name) const;
};

// The largest mean of `values` over 0.02 of strain around a point of the curve; the mean over the
// last quarter of the strain. Strains increase.
double smoothed_peak(const std::vector<double>& strains, const std::vector<double>& values);
double mean_of_last_quarter(const std::vector<double>& strains, const std::vector<double>& values);

}  // namespace run_study
