// SPDX-License-Identifier: BSL-1.0
#pragma once
// Runs that each leave a file, some at a time. Files that are there already are kept, so that a
// study can be stopped and continued.

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace run_table {

struct Task {
  std::filesystem::path file;
  std::string key;                     // first line of the file: all that the result depends on
  std::function<std::string()> run{};  // the lines below it
};

// What the task has left, without the key. Nothing if its file is missing or has another key.
[[nodiscard]] std::optional<std::string> result_of(const Task& task);

// Makes the results that are missing, in this order; says on stderr how far it is. Throws
// std::runtime_error after the last one if any has failed.
void make_results(const std::vector<Task>& tasks, unsigned jobs);

// "mean ± standard deviation", or the value if it is the only one. `format` is that of printf for
// one number, which is multiplied by `unit`.
[[nodiscard]] std::string cell(const std::vector<double>& values, const char* format,
                               double unit = 1);

}  // namespace run_table
