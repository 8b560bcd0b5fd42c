// SPDX-License-Identifier: BSL-1.0
#pragma once
// Numbers of a biaxial test that tables compare.

#include <array>
#include <string>
#include <vector>

#include "tasks.hpp"

namespace run_table {

// Energies as shares of the boundary work of shear.
struct BiaxialNumbers {
  double peak = 0;               // sin phi, mean over 2 % of strain
  double residual = 0;           // sin phi, mean over the last quarter
  double volumetric_strain = 0;  // at the end, contraction positive
  double coordination = 0;       // 2 M / N at the end
  double breakages = 0;
  double law = 0;        // energy that the law cannot explain; made: negative
  double splitting = 0;  // energy lost in breaks; made: negative
  double damping = 0;
  double overlap = 0;    // mean depth over mean diameter
  double step_time = 0;  // processor time of a step [us]
  double made = 0;       // energy made by law and splitting together
};

// The numbers in a file of a run, and in tables. Those without a title are in the file alone.
struct Column {
  const char* name;
  double BiaxialNumbers::*value;
  const char* title = nullptr;
  const char* format = nullptr;
  double unit = 1;
};
inline constexpr std::array<Column, 11> columns{
    {{"peak_sin_phi", &BiaxialNumbers::peak, "peak sin φ", "%.3f"},
     {"residual_sin_phi", &BiaxialNumbers::residual, "residual", "%.3f"},
     {"volumetric_strain", &BiaxialNumbers::volumetric_strain, "volume %", "%.1f", 100},
     {"coordination", &BiaxialNumbers::coordination, "2M/N", "%.2f"},
     {"breakages", &BiaxialNumbers::breakages, "breakages", "%.0f"},
     {"law_share", &BiaxialNumbers::law, "law %", "%.2f", 100},
     {"splitting_share", &BiaxialNumbers::splitting, "splitting %", "%.2f", 100},
     {"damping_share", &BiaxialNumbers::damping, "damping %", "%.1f", 100},
     {"overlap_ratio", &BiaxialNumbers::overlap, "overlap %", "%.2f", 100},
     {"step_time_us", &BiaxialNumbers::step_time, "step µs", "%.0f"},
     {"made_share", &BiaxialNumbers::made}}};

// As the lines of a task's file.
[[nodiscard]] std::string to_lines(const BiaxialNumbers& numbers);
// Throws std::runtime_error for a file with other lines.
[[nodiscard]] BiaxialNumbers numbers_of(const Task& task);

// Runs of one row of a table.
struct Row {
  std::string title;  // cells of the first columns, with "|" between them
  std::vector<BiaxialNumbers> runs{};
};
// In Markdown; `first` are the titles of the first columns.
[[nodiscard]] std::string table(const std::vector<std::string>& first,
                                const std::vector<Row>& rows);
// As table.md in the folder and on stdout.
void leave_table(const std::filesystem::path& folder, const std::vector<std::string>& first,
                 const std::vector<Row>& rows);

}  // namespace run_table
