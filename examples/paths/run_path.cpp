// SPDX-License-Identifier: BSL-1.0
// The only source that knows the type of the simulation.

#include "run_path.hpp"

#include <riprap/experiment/loading_path.hpp>
#include <riprap/experiment/validity_check.hpp>
#include <riprap/measurement/breakage_indices.hpp>
#include <riprap/measurement/grading.hpp>
#include <riprap/output/assembly_picture.hpp>
#include <riprap/output/curve_files.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>

#include "../command_line/checkpoints.hpp"

namespace paths {

namespace {

// An observer that measures what the curve does not.
struct Measures {
  Run& run;

  template <class Sim>
  void begin_stage(const riprap::LoadingView<Sim>& view) {
    if (view.stage != riprap::Stage::loading || view.loading_stage > 0) return;
    const auto region = view.sim.boundary().region(view.sim.particles());
    run.area = region.area();
    run.solid_area = region.solid_area();
    run.thickness = view.sim.particles().thickness();
  }
  template <class Sim>
  void record(const riprap::LoadingView<Sim>& view) {
    const riprap::Particles& particles = view.sim.particles();
    run.hardin.push_back(riprap::hardin_breakage(riprap::grading_before_breakage(particles),
                                                 riprap::grading(particles)));
  }

  static constexpr bool names_all_members = false;
  static void for_each_field(auto& self, auto&& visit) {
    visit("area", self.run.area);
    visit("solid_area", self.run.solid_area);
    visit("thickness", self.run.thickness);
    visit("hardin", self.run.hardin);
  }
};

// An observer that says how far the run is.
struct Watch {
  run_table::ProgressLine& line;
  std::size_t stages;

  template <class Sim>
  void progress(const riprap::LoadingView<Sim>& view) {
    line.at((static_cast<double>(view.stage_index) + view.done) / static_cast<double>(stages));
  }

  static constexpr bool names_all_members = false;
  static void for_each_field(auto& /*self*/, auto&& /*visit*/) {}
};

auto simulation_of(const Sample& s) {
  using namespace riprap;
  return Simulation{Model{}
                        .contact_law(EnergyConservingSpring{.normal_stiffness = s.stiffness,
                                                            .tangential_stiffness = s.stiffness})
                        .criterion(HoekBrown{.compressive_strength = s.strength}),
                    random_assembly({.count = s.particles, .seed = s.seed}), Rock{}};
}

riprap::LoadingPath<> path_of(const PlannedRun& plan) {
  return {.confining_pressure = plan.pressure, .stages = plan.stages};
}

std::string hardin_csv(const Run& run) {
  std::string text = "stage,axial_strain,hardin_b_r\n";
  for (std::size_t i = 0; i < run.points.size(); ++i)
    text += std::to_string(run.points[i].stage_index) + "," +
            riprap::to_text(run.points[i].axial_strain) + "," + riprap::to_text(run.hardin[i]) +
            "\n";
  return text;
}

}  // namespace

std::string PlannedRun::name() const {
  std::string text = variant + "_seed_" + std::to_string(sample.seed);
  for (char& c : text)
    if (c == ' ' || c == ',') c = '_';
  return text;
}

void check_path(const PlannedRun& plan) {
  auto sim = simulation_of(plan.sample);
  static_cast<void>(path_of(plan).start(sim));
}

Run run_path(const PlannedRun& plan, const command_line::Saving& saving,
             run_table::ProgressLine& line) {
  using namespace riprap;
  const Sample& s = plan.sample;
  auto sim = simulation_of(s);
  sim.set_breakage(s.breakage);

  Run run{.plan = plan};
  Curve curve;
  const bool goes_on = !saving.checkpoints().files().empty();
  CurveFiles tables{curve, saving.folder, goes_on ? OldFile::keep : OldFile::replace};
  Measures measures{run};
  ValidityCheck check;
  line.begin(plan.name(), 1);
  Watch watch{line, plan.stages.size()};
  auto path = path_of(plan).start(sim, curve, tables, measures, check, watch);
  if (goes_on) command_line::go_on(saving, path, sim, curve, tables, measures, check, watch);
  if (!path.finished()) {
    command_line::run_with_checkpoints(saving, path, sim, curve, tables, measures, check, watch);
    if (!path.result().interrupted)
      saving.checkpoints().write(sim, path, saving.given, curve, tables, measures, check, watch);
  }
  const PathResult& result = path.result();

  run.points = curve.points();
  run.breakages_before = curve.breakages_before_shear();
  run.stages = result.stages;
  run.warnings = check.warnings();
  run.interrupted = result.interrupted;
  write_file((saving.folder / "hardin.csv").string(), hardin_csv(run));
  if (!plan.picture.empty())
    assembly_picture(sim.particles(), s.breakage ? sim.failed_ratios() : std::vector<double>{},
                     plan.picture)
        .save((saving.folder / "assembly.svg").string());
  return run;
}

}  // namespace paths
