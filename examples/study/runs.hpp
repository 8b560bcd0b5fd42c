// SPDX-License-Identifier: BSL-1.0
#pragma once
// The runs of a study: what each is made with, and what its folder is called.

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "table_file.hpp"

namespace run_study {

struct Run {
  std::string folder{};  // its name
  std::string row{};     // name of the row of the table, or none
  // Options that tell the combinations of the row apart, with their values.
  std::vector<std::pair<std::string, std::string>> coordinates{};
  std::uint64_t seed = 1;
  std::string toml{};                               // its parameters.toml
  std::map<std::string, std::string> parameters{};  // the options in it
  double work = 1;                                  // about how long it takes [any unit]
  int line = 0;                                     // of its row in the table
};

struct Study {
  std::vector<std::string> options;  // that the table names, in its order
  std::vector<Run> runs;
};

// The runs in the order of the table: the last list of a row varies faster than those before it,
// seeds fastest. Throws riprap::InvalidInput that names file, line, option and rule for an option
// that there is not, a value that breaks a rule, and a run that comes twice.
Study study_of(const TableFile& file);

// The options of a file of parameters.
std::map<std::string, std::string> options_in(const std::string& toml);

// Every n-th run, from the i-th on, i from 1.
struct Shard {
  std::size_t index = 1;
  std::size_t count = 1;
};
// Throws riprap::InvalidInput for what is not I/N with 1 <= I <= N.
Shard shard_from(const std::string& text);
std::vector<Run> runs_of_shard(const std::vector<Run>& runs, const Shard& shard);

}  // namespace run_study
