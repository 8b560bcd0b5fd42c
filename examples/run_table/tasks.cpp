// SPDX-License-Identifier: BSL-1.0
#include "tasks.hpp"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <mutex>
#include <sstream>
#include <stdexcept>

#include <riprap/output/file.hpp>

#include "work_through.hpp"

namespace run_table {

namespace fs = std::filesystem;

std::optional<std::string> result_of(const Task& task) {
  std::ifstream file(task.file);
  std::string line;
  if (!std::getline(file, line) || line != task.key) return std::nullopt;
  std::ostringstream rest;
  rest << file.rdbuf();
  return rest.str();
}

namespace {

// What several threads report to.
class Progress {
 public:
  explicit Progress(std::size_t tasks) : tasks_(tasks) {}

  void finished(const std::string& error) {
    const std::scoped_lock lock(mutex_);
    if (error_.empty()) error_ = error;
    ++done_;
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
    const double left = static_cast<double>(tasks_ - done_) / static_cast<double>(done_);
    std::fprintf(stderr, "%zu of %zu runs, about %s left\n", done_, tasks_,
                 duration_text(elapsed.count() * left).c_str());
  }
  [[nodiscard]] const std::string& error() const { return error_; }

 private:
  std::mutex mutex_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::size_t tasks_;
  std::size_t done_ = 0;
  std::string error_;
};

}  // namespace

void make_results(const std::vector<Task>& tasks, unsigned jobs) {
  std::vector<const Task*> missing;
  for (const Task& task : tasks)
    if (!result_of(task)) missing.push_back(&task);
  Progress progress(missing.size());
  work_through(missing.size(), jobs, [&](std::size_t k) {
    const Task& task = *missing[k];
    std::string error;
    try {
      riprap::write_file(task.file, task.key + "\n" + task.run());
    } catch (const std::exception& e) {
      error = task.file.string() + ": " + e.what();
    }
    progress.finished(error);
  });
  if (!progress.error().empty()) throw std::runtime_error(progress.error());
}

std::string cell(const std::vector<double>& values, const char* format, double unit) {
  double mean = 0;
  for (const double v : values) mean += unit * v / static_cast<double>(values.size());
  double squares = 0;
  for (const double v : values) squares += (unit * v - mean) * (unit * v - mean);
  char text[80];
  if (values.size() < 2) {
    std::snprintf(text, sizeof text, format, mean);
    return text;
  }
  const std::string both = std::string(format) + " ± " + format;
  std::snprintf(text, sizeof text, both.c_str(), mean,
                std::sqrt(squares / static_cast<double>(values.size() - 1)));
  return text;
}

}  // namespace run_table
