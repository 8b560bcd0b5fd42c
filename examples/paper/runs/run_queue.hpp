// SPDX-License-Identifier: BSL-1.0
#pragma once
// Runs side by side, each on a thread of its own.

#include <filesystem>
#include <string>
#include <vector>

#include "plan.hpp"

namespace study {

struct StudyOutcome {
  std::size_t finished = 0;  // just now
  std::size_t kept = 0;      // finished before
  std::vector<std::string> failed;
};

// Makes the runs that `folder` does not have yet, `jobs` at a time, and says on the standard error
// how far they are. A run that fails leaves its reason in an error.txt and does not stop the
// others.
StudyOutcome make_runs(const std::vector<RunPlan>& plans, const std::filesystem::path& folder,
                       unsigned jobs);

}  // namespace study
