// SPDX-License-Identifier: BSL-1.0
// Breakable particles, free in their stress analysis.

#include "study_run.hpp"

void study::run_wb(const RunPlan& plan, const std::filesystem::path& folder, WorkDone& done) {
  run_model(plan, breakable_model(plan), folder, done);
}
