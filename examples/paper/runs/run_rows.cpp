// SPDX-License-Identifier: BSL-1.0
// Rows of the study that take another model than the series: crack lines, support, boundary.

#include <riprap/breakage/line_fit/line_fit_choice.hpp>
#include <riprap/particle/random_box_assembly.hpp>
#include <riprap/stress/support/two_pinned_contacts.hpp>

#include "study_run.hpp"

namespace study {

namespace {

using LineFit = riprap::LineFitChoice<riprap::MeanTensionLine, riprap::FailurePlaneThroughCentroid>;

template <class ModelType>
void run_periodic(const RunPlan& plan, ModelType model, const std::filesystem::path& folder,
                  WorkDone& done) {
  run_model(plan, std::move(model).boundary(riprap::PeriodicCell{}),
            riprap::random_periodic_assembly(plan.assembly()), folder, done);
}

}  // namespace

void run_line_fit(const RunPlan& plan, const std::filesystem::path& folder, WorkDone& done) {
  LineFit fit;
  if (plan.variation == Variation::failure_plane)
    fit.chosen = riprap::FailurePlaneThroughCentroid{};
  run_model(plan, breakable_model(plan).line_fit(fit), folder, done);
}

void run_pinned(const RunPlan& plan, const std::filesystem::path& folder, WorkDone& done) {
  run_model(plan, breakable_model(plan).support(riprap::TwoPinnedContacts{}), folder, done);
}

void run_periodic(const RunPlan& plan, const std::filesystem::path& folder, WorkDone& done) {
  if (plan.mode == Mode::nb)
    run_periodic(plan, unbreakable_model(plan), folder, done);
  else
    run_periodic(plan, breakable_model(plan), folder, done);
}

}  // namespace study
