// SPDX-License-Identifier: BSL-1.0
// contact_models: contact models compared in the biaxial test: strength, energy, breakages, cost
// Runs that the folder has already are kept, so that a study can be stopped and continued.

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <riprap/output/file.hpp>

#include "../command_line/program.hpp"
#include "../run_table/options.hpp"
#include "../run_table/tasks.hpp"
#include "run.hpp"

namespace fs = std::filesystem;
using namespace contact_models;

namespace {

struct NamedModel {
  const char* name;
  const char* description;
  BiaxialNumbers (*run)(const Setup&);
};
const std::vector<NamedModel> models{
    {"chord", "OverlapChord, LinearSpringCoulomb, MassFloor 0.12", run_chord},
    {"incremental", "OverlapChord, IncrementalSpring, MassFloor 0.12", run_incremental},
    {"area", "OverlapChord, OverlapAreaSpring, MassFloor 0.12", run_area},
    {"moments", "OverlapMoments, EnergyConservingSpring, MassFloor 0.17", run_moments},
};

struct Options : run_table::RunOptions {
  std::vector<double> pressures{0.5, 2, 8, 14};  // [MPa]
  unsigned samples = 8;
  unsigned particles = 500;
  double strain = 0.2;
};

run_table::Task task(const NamedModel& model, const Setup& setup, const fs::path& file) {
  char key[160];
  std::snprintf(key, sizeof key, "# %s, %g MPa, seed %llu, %u particles, strain %g",
                model.description, 1e-6 * setup.pressure,
                static_cast<unsigned long long>(setup.seed), setup.particles, setup.strain);
  return {file, key, [&model, setup] { return to_lines(model.run(setup)); }};
}

int compare(const Options& o) {
  riprap::make_folder(o.out);
  std::vector<run_table::Task> tasks;
  std::vector<run_table::Row> rows;
  for (const double pressure : o.pressures)
    for (const NamedModel& model : models) {
      std::ostringstream title;
      title << pressure << " | " << model.name;
      rows.push_back({title.str()});
      for (unsigned seed = 1; seed <= o.samples; ++seed) {
        std::ostringstream name;
        name << model.name << "_" << pressure << "MPa_" << seed << ".csv";
        tasks.push_back(task(model, {1e6 * pressure, seed, o.particles, o.strain},
                             fs::path(o.out) / name.str()));
      }
    }
  run_table::make_results(tasks, o.jobs);
  for (std::size_t k = 0; k < tasks.size(); ++k)
    rows[k / o.samples].runs.push_back(run_table::numbers_of(tasks[k]));
  run_table::leave_table(o.out, {"MPa", "model"}, rows);
  return command_line::finished;
}

}  // namespace

int main(int argc, char** argv) {
  Options o;
  o.out = "contact_models";
  CLI::App app{"Contact models compared in the biaxial test. Mean and standard deviation of the "
               "samples; energies as shares of the boundary work, what is made is negative."};
  app.add_option("--pressures", o.pressures, "confining pressures [MPa]")->capture_default_str();
  app.add_option("--samples", o.samples, "seeds 1, 2, ...")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_option("--particles", o.particles, "of a sample")->capture_default_str();
  app.add_option("--strain", o.strain, "axial strain of shear")->capture_default_str();
  run_table::add_options(app, o, "runs");
  command_line::parse_or_exit(app, [&] { app.parse(argc, argv); });
  return command_line::run_program({}, [&] { return compare(o); });
}
