// SPDX-License-Identifier: BSL-1.0
#pragma once
// One run of the study with any model, and the files it leaves.

#include <atomic>
#include <chrono>
#include <filesystem>

#include <riprap/experiment/validity_check.hpp>
#include <riprap/riprap.hpp>

#include "band_record.hpp"
#include "plan.hpp"
#include "run_json.hpp"
#include "run_pictures.hpp"
#include "run_process.hpp"
#include "run_record.hpp"

namespace study {

// Work done so far, in the unit of RunPlan::work; another thread reads it.
using WorkDone = std::atomic<double>;

// An observer that tells how much is done.
struct WorkMeter {
  const RunPlan& plan;
  WorkDone& done;

  template <class Sim>
  void progress(const riprap::BiaxialView<Sim>& view) const {
    using riprap::Stage;
    const double before = plan.work_before();
    done = view.stage == Stage::shear ? before + view.done * plan.work_in_shear()
                                      : before * (static_cast<double>(view.stage) + view.done) / 3;
  }
};

// The library's defaults with what the plan changes of them.
inline auto unbreakable_model(const RunPlan& plan) {
  return with_contacts_of(plan, riprap::Model{}.criterion(riprap::NeverFails{}));
}
inline auto breakable_model(const RunPlan& plan) {
  return with_contacts_of(plan,
                          riprap::Model{}.criterion(plan.criterion()).splitter(plan.splitter()));
}

// Throws riprap's errors; writes run.json last, so that a folder with one is complete.
template <class ModelType>
void run_model(const RunPlan& plan, ModelType model, const riprap::Assembly& assembly,
               const std::filesystem::path& folder, WorkDone& done) {
  using namespace riprap;
  const auto begun = std::chrono::steady_clock::now();
  Simulation sim{std::move(model), assembly, Rock{}};
  const BiaxialTest test = plan.test();
  Curve curve;
  RunRecord record;
  BandRecord band_record;
  ValidityCheck check;
  BiaxialResult result;
  const WorkMeter meter{plan, done};
  Json j = {{"mode", to_text(plan.mode)},
            {"variation", to_text(plan.variation)},
            {"pressure_Pa", plan.pressure},
            {"seed", plan.seed},
            {"particles", plan.particles}};
  if (plan.has_pictures()) {
    RunPictures pictures(plan, folder);
    if constexpr (Simulation<ModelType>::breakable) {
      BreakProcess process(plan);
      result = test.run(sim, curve, record, band_record, check, pictures, process, meter);
      process.save(folder);
    } else {
      result = test.run(sim, curve, record, band_record, check, pictures, meter);
    }
  } else {
    result = test.run(sim, curve, record, band_record, check, meter);
  }
  record.write(j);
  // In a periodic cell there is no centre, and particles leave it on one side to come in again.
  if (plan.variation != Variation::periodic_cell) band_record.write(j);
  j["curve"] = curve_json(curve);
  j["grading"] = grading_json(sim.particles());
  j["numbers"] = numbers_json(curve, result,
                              stiffness_level(plan.pressure, sim.particles().thickness(),
                                              sim.contacts().law().peak_stiffness()));
  j["stages"] = stages_json(result);
  j["energy"] = energy_json(curve);
  if (!curve.points().empty())
    check.check_energy(curve.points().back().energy, curve.points().back().axial_strain);
  j["warnings"] = check.warnings();
  j["parameters"] = plan.parameters();
  j["wall_s"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  write_file((folder / "run.json.part").string(), j.dump() + "\n");
  std::filesystem::rename(folder / "run.json.part", folder / "run.json");
}

template <class ModelType>
void run_model(const RunPlan& plan, ModelType model, const std::filesystem::path& folder,
               WorkDone& done) {
  run_model(plan, std::move(model), riprap::random_assembly(plan.assembly()), folder, done);
}

// A model each, compiled apart from each other.
void run_nb(const RunPlan& plan, const std::filesystem::path& folder, WorkDone& done);
void run_wb(const RunPlan& plan, const std::filesystem::path& folder, WorkDone& done);
void run_line_fit(const RunPlan& plan, const std::filesystem::path& folder, WorkDone& done);
void run_periodic(const RunPlan& plan, const std::filesystem::path& folder, WorkDone& done);
void run_pinned(const RunPlan& plan, const std::filesystem::path& folder, WorkDone& done);
void run_recommended(const RunPlan& plan, const std::filesystem::path& folder, WorkDone& done);
void run_paper(const RunPlan& plan, const std::filesystem::path& folder, WorkDone& done);

}  // namespace study
