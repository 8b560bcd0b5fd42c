// SPDX-License-Identifier: BSL-1.0
// Rows of the study that take a preset of the library.

#include <riprap/simulation/presets/bagherzadeh_2008.hpp>
#include <riprap/simulation/presets/recommended.hpp>

#include "study_run.hpp"

namespace study {

void run_recommended(const RunPlan& plan, const std::filesystem::path& folder, WorkDone& done) {
  run_model(plan, riprap::presets::recommended(), folder, done);
}

void run_paper(const RunPlan& plan, const std::filesystem::path& folder, WorkDone& done) {
  run_model(plan, riprap::presets::bagherzadeh_2008(), folder, done);
}

}  // namespace study
