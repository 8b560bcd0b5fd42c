// SPDX-License-Identifier: BSL-1.0
#pragma once
// One biaxial test with any model, and everything it leaves in the output folder.

#include <filesystem>
#include <string>

#include <riprap/output/assembly_picture.hpp>
#include <riprap/output/curve_charts.hpp>
#include <riprap/output/displacement_picture.hpp>
#include <riprap/output/force_chain_picture.hpp>
#include <riprap/output/paraview.hpp>

#include "options.hpp"
#include "summary.hpp"

// What all programs share.
inline auto breakable_model(const Options& o) {
  return riprap::Model{}
      .criterion(chosen_criterion(o))
      .line_fit(chosen_line_fit(o))
      .plane_state(chosen_plane(o))
      .mesher(riprap::UniformMesher{.triangles = o.mesh_triangles})
      .trigger(riprap::FailedElementRatio{.critical = o.ratf})
      .splitter(riprap::StraightCut{.minimum_area = o.minimum_piece_area,
                                    .maximum_aspect = o.maximum_piece_aspect})
      .check_every(o.check_every)
      .execution(AnyExecution{o.threads});
}

// The same with a choice of contact law, integrator and support.
inline auto model_of_choices(const Options& o) {
  return breakable_model(o)
      .contact(chosen_contact(o))
      .integrator(chosen_integrator(o))
      .support(chosen_support(o));
}

// The assembly that goes with a boundary.
inline riprap::Assembly assembly_for(const riprap::StrainField&, const Options& o) {
  return riprap::random_assembly(chosen_assembly(o));
}
inline riprap::Assembly assembly_for(const riprap::RigidPlatens&, const Options& o) {
  return riprap::random_platen_assembly(chosen_assembly(o));
}
inline riprap::Assembly assembly_for(const riprap::PeriodicCell&, const Options& o) {
  return riprap::random_periodic_assembly(chosen_assembly(o));
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
};

template <class ModelType, class... Observers>
void run(const Options& o, ModelType model, Observers&... observers) {
  using namespace riprap;
  const std::filesystem::path folder = o.out;
  std::filesystem::create_directories(folder);
  const Assembly assembly = assembly_for(model.motion_model.boundary, o);
  Simulation sim{std::move(model), assembly, Rock{}};
  sim.set_breakage(o.breakage);
  const BiaxialTest test{.confining_pressure = o.pressure,
                         .axial_strain = o.strain,
                         .inertial_number = o.inertial_number};
  Curve curve;
  Progress progress;
  OptionalSeries series{o.paraview, ParaViewSeries{folder / "paraview"}};
  const auto write_records = [&] {
    write_csv(folder / "curve.csv", curve);
    write_file(folder / "energy.csv", energy_csv(curve));
    write_file(folder / "breakages.csv", breakages_csv(curve));
    if (!curve.points().empty()) chart_sheet(curve_charts(curve)).save(folder / "curves.svg");
  };
  BiaxialResult result;
  try {
    result = test.run(sim, curve, Pictures{folder}, series, progress, observers...);
  } catch (...) {
    write_records();  // what was computed is kept
    throw;
  }
  write_records();
  write_file(folder / "summary.json",
             summary(o, sim, test, result, curve, progress.warnings()).dump(2) + "\n");
  print_summary(o, sim, curve, folder.string());
}
