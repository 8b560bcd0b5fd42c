// SPDX-License-Identifier: BSL-1.0
// Particles that never break: no stress analysis in the program.

#include "study_run.hpp"

void study::run_nb(const RunPlan& plan, const std::filesystem::path& folder, WorkDone& done) {
  run_model(plan, unbreakable_model(plan), folder, done);
}
