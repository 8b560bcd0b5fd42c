// SPDX-License-Identifier: BSL-1.0
// Breakable particles, pinned at two contacts in their stress analysis, as the paper has it.

#include <riprap/stress/support/two_pinned_contacts.hpp>

#include "study_run.hpp"

void study::run_pinned(const RunPlan& plan, const std::filesystem::path& folder, WorkDone& done) {
  run_model(plan, riprap::Model{}.support(riprap::TwoPinnedContacts{}), folder, done);
}
