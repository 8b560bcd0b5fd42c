// SPDX-License-Identifier: BSL-1.0
#pragma once
// Finished runs, together with those that differ from them in the seed alone.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "runs.hpp"

namespace run_study {

struct FinishedRun {
  const Run* run;
  std::vector<double> results;  // one for each of result_columns()
};
// Of the study, those whose folder is finished, in the order of the table.
std::vector<FinishedRun> finished_runs(const Study& study, const std::filesystem::path& folder);

// All seeds of one set of parameters.
struct Combination {
  std::vector<const FinishedRun*> runs;

  [[nodiscard]] const Run& first() const { return *runs.front()->run; }
  // Of a column of the results.
  [[nodiscard]] std::vector<double> values(std::size_t column) const;
};
std::vector<Combination> combinations_of(const std::vector<FinishedRun>& runs);

// The value of an option in a run, or the name of its row for "row"; empty if it has no meaning.
std::string value_of(const Run& run, const std::string& option);
// The same number, or the same text.
bool is_same_value(const std::string& a, const std::string& b);

// "pressure=2e6", "row=base case"; or "pressure", whose first value in the table is meant.
struct Against {
  std::string option;
  std::string value;
};
// Throws riprap::InvalidInput for an option that does not tell the combinations apart, and for a
// value that it does not have.
Against against_from(const std::string& text, const std::vector<Run>& runs);

// What a combination is compared with: the one with the value of `against`, and of its row in all
// else; against a row the one of that row whose lists have the same values. Nothing if it is that
// itself, or there is none.
const Combination* reference_of(const Combination& combination, const Against& against,
                                const std::vector<Combination>& all);

// Differences of a column to a reference, of the seeds that both have.
std::vector<double> paired_differences(const Combination& combination, const Combination& reference,
                                       std::size_t column);

}  // namespace run_study
