// SPDX-License-Identifier: BSL-1.0
#pragma once
// The options of every program that makes runs of a table.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>
#include <thread>

namespace run_table {

struct RunOptions {
  unsigned jobs = std::max(1U, std::thread::hardware_concurrency());
  std::string out;
};

// `what` is made and kept: "runs", "parts".
inline void add_options(CLI::App& app, RunOptions& options, const std::string& what) {
  app.add_option("--jobs", options.jobs, what + " at a time")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_option("--out", options.out,
                 "folder of the results; finished " + what + " in it are kept")
      ->capture_default_str();
}

}  // namespace run_table
