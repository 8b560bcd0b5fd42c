// SPDX-License-Identifier: BSL-1.0
#pragma once
// The command line of the study example.

#include <string>
#include <vector>

#include "make_runs.hpp"
#include "runs.hpp"

namespace run_study {

struct Options {
  std::string table;
  Making making{};
  Shard shard{};
  unsigned seeds = 0;  // of each row at most; 0 for all
  bool list = false;
  bool summary = false;
  std::string against{};
  std::vector<std::string> plots{};
  std::vector<std::string> where{};
  bool log_x = false;
};

// Exits on --help and on a command that is wrong.
Options read_options(int argc, char** argv);

// The file of a table, or that of the table of this name beside the example. Throws
// riprap::InvalidInput if there is neither.
std::string table_path(const std::string& table);

}  // namespace run_study
