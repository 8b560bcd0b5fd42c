// SPDX-License-Identifier: BSL-1.0
#pragma once
// One biaxial test with any model, and everything it leaves in the output folder.

#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include <riprap/output/assembly_picture.hpp>
#include <riprap/output/curve_charts.hpp>
#include <riprap/output/curve_files.hpp>
#include <riprap/output/displacement_picture.hpp>
#include <riprap/output/force_chain_picture.hpp>
#include <riprap/output/frames.hpp>
#include <riprap/output/paraview.hpp>

#include "checkpoints.hpp"
#include "models.hpp"
#include "result_files.hpp"
#include "runs.hpp"
#include "summary.hpp"

// A preset, with what it leaves to options.
template <class Preset>
auto preset_model(const Preset& preset, const Options& o) {
  return preset.broad_phase(o.broad_phase)
      .damping(o.damping)
      .splitter(o.splitter)
      .check_every(o.check_every)
      .execution(AnyExecution{static_cast<int>(o.threads)});
}

// The assembly that goes with a boundary.
inline riprap::Assembly assembly_for(const riprap::StrainField&, const Options& o) {
  return riprap::random_assembly(o.assembly);
}
inline riprap::Assembly assembly_for(const riprap::RigidPlatens&, const Options& o) {
  return riprap::random_platen_assembly(o.assembly);
}
inline riprap::Assembly assembly_for(const riprap::PeriodicCell&, const Options& o) {
  return riprap::random_periodic_assembly(o.assembly);
}

// An observer that draws the assembly and its forces at the start and the end of shear, and the
// paths of the particles between them.
struct Pictures {
  std::filesystem::path folder;
  riprap::DisplacementPaths paths{};

  template <class Sim>
  void record(const riprap::BiaxialView<Sim>& view) {
    paths.record(view);
  }
  template <class Sim>
  void record_break(const riprap::BiaxialView<Sim>& view, const riprap::BreakEvent& event) {
    paths.record_break(view, event);
  }

  template <class Sim>
  void begin_stage(const riprap::BiaxialView<Sim>& view) const {
    if (view.stage == riprap::Stage::shear) draw(view, "before", "at the start of shear");
  }
  template <class Sim>
  void end_stage(const riprap::BiaxialView<Sim>& view) const {
    if (view.stage != riprap::Stage::shear) return;
    const std::string when =
        "at " + riprap::to_text(std::round(1000 * view.axial_strain()) / 10) + " % axial strain";
    draw(view, "after", when);
    riprap::displacement_picture(view.sim.particles(), paths,
                                 "Displacement paths " + when + ", " + pressure_text(view))
        .save(folder / "displacement.svg");
  }

  static constexpr bool names_all_members = false;
  static void for_each_field(auto& self, auto&& visit) { visit("paths", self.paths); }

 private:
  template <class Sim>
  static std::string pressure_text(const riprap::BiaxialView<Sim>& view) {
    return riprap::to_text(view.confining_pressure / 1e6) + " MPa";
  }
  template <class Sim>
  void draw(const riprap::BiaxialView<Sim>& view, const std::string& name,
            const std::string& when) const {
    const auto& particles = view.sim.particles();
    const std::string pressure = pressure_text(view);
    const std::vector<double> ratios =
        Sim::breakable ? view.sim.failed_ratios() : std::vector<double>{};
    riprap::assembly_picture(particles, ratios, "Assembly " + when + ", " + pressure)
        .save(folder / ("assembly_" + name + ".svg"));
    riprap::force_chain_picture(particles, view.sim.contacts(),
                                "Normal contact forces " + when + ", " + pressure,
                                // Forces grow with the pressure; the default is for 2 MPa.
                                riprap::ForceClasses{}.scaled(view.confining_pressure / 2e6))
        .save(folder / ("forces_" + name + ".svg"));
  }
};

// An observer that writes the series for ParaView where it is wanted.
struct OptionalSeries {
  bool wanted;
  riprap::ParaViewSeries series;

  template <class Sim>
  void record(const riprap::BiaxialView<Sim>& view) {
    if (wanted) series.record(view);
  }

  static constexpr bool names_all_members = false;
  static void for_each_field(auto& self, auto&& visit) { visit("series", self.series); }
};

// An observer that writes frames where they are wanted.
struct OptionalFrames {
  bool wanted;
  riprap::FrameWriter frames;

  template <class Sim>
  void begin_stage(const riprap::BiaxialView<Sim>& view) {
    if (wanted) frames.begin_stage(view);
  }
  template <class Sim>
  void progress(const riprap::BiaxialView<Sim>& view) {
    if (wanted) frames.progress(view);
  }
  template <class Sim>
  void end_stage(const riprap::BiaxialView<Sim>& view) {
    if (wanted) frames.end_stage(view);
  }
  template <class Sim>
  void before_splits(const Sim& sim) {
    if (wanted) frames.before_splits(sim);
  }
  template <class Sim>
  void record_break(const riprap::BiaxialView<Sim>& view, const riprap::BreakEvent& event) {
    if (wanted) frames.record_break(view, event);
  }
  // For checkpoints.
  [[nodiscard]] std::string appended_file() const { return frames.appended_file(); }

  static constexpr bool names_all_members = false;
  static void for_each_field(auto& self, auto&& visit) { visit("frames", self.frames); }
};

inline void save_charts(const riprap::Curve& curve, const std::filesystem::path& folder) {
  if (!curve.points().empty())
    riprap::chart_sheet(riprap::curve_charts(curve)).save(folder / "curves.svg");
}

// What was recorded is in the tables already; an error here must not hide why the run failed.
template <class Sim>
void keep_failed_run(const Options& o, const Sim& sim, const riprap::Curve& curve,
                     const std::vector<std::string>& warnings, const std::string& error) {
  const std::filesystem::path folder = o.out;
  try {
    riprap::write_file(folder / "summary.json",
                       failure_summary(o, sim, warnings, error).dump(2) + "\n");
    save_charts(curve, folder);
  } catch (const std::exception&) {
    return;
  }
}

template <class ModelType, class... Observers>
Outcome run(const Options& o, ModelType model, Observers&... observers) {
  using namespace riprap;
  command_line::note_signals();
  const Assembly assembly = assembly_for(model.motion_model.boundary, o);
  Simulation sim{std::move(model), assembly, o.rock};
  sim.set_breakage(o.breakage == "on");
  o.test.validate();

  // Everything in the command is right: what stood in the folder may go.
  const std::filesystem::path folder = o.out;
  make_folder(folder);
  // One that was stopped before its first checkpoint begins anew.
  const command_line::Saving saving = saving_of(o);
  const bool resumes = !o.resume.empty() && !saving.checkpoints().files().empty();
  if (!resumes) remove_results(folder);
  if (!resumes) command_line::write_parameters(o.toml, folder);
  Curve curve;
  CurveFiles tables{curve, folder, resumes ? OldFile::keep : OldFile::replace};
  OptionalSeries series{o.paraview, ParaViewSeries{paraview_folder(folder)}};
  OptionalFrames frames{o.frames, FrameWriter{frames_folder(folder)}};
  Pictures pictures{folder};
  Progress progress;
  auto test = o.test.start(sim, curve, tables, series, frames, pictures, progress, observers...);
  if (resumes) {
    resume(o, test, sim, curve, tables, series, frames, pictures, progress, observers...);
    command_line::write_parameters(o.toml, folder);
  }
  try {
    command_line::run_with_checkpoints(saving, test, sim, curve, tables, series, frames, pictures,
                                       progress, observers...);
  } catch (const std::exception& error) {
    keep_failed_run(o, sim, curve, progress.warnings(), error.what());
    // Whatever the kind of error: the command was right, and the run failed.
    throw SimulationError(error.what());
  }
  const BiaxialResult result = test.result();
  if (!curve.points().empty())
    progress.check().check_energy(curve.points().back().energy, curve.points().back().axial_strain);
  write_file(folder / "summary.json",
             summary(o, sim, result, curve, progress.check()).dump(2) + "\n");
  save_charts(curve, folder);
  print_summary(o, sim, result, curve);
  print_checks(progress.check().table());
  if (!result.interrupted) saving.checkpoints().clear();
  return result.interrupted ? Outcome::interrupted : Outcome::finished;
}
