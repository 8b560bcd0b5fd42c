// SPDX-License-Identifier: BSL-1.0
#pragma once
// The results of a study as tables.

#include <optional>
#include <string>
#include <vector>

#include "combinations.hpp"

namespace run_study {

// A row for each run: name, options of the table, seed, results.
std::string runs_csv(const Study& study, const std::vector<FinishedRun>& runs);
// A row for each combination: options, number of runs; of each result mean, standard deviation and
// the ends of the 95 % interval of the mean; against a reference the mean difference of pairs of
// the same seed and the ends of its interval.
std::string summary_csv(const Study& study, const std::vector<Combination>& all,
                        const std::optional<Against>& against);
// A row for each combination in Markdown: mean and standard deviation of the results that matter
// most.
std::string table_md(const Study& study, const std::vector<Combination>& all);

}  // namespace run_study
