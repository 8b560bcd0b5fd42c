// SPDX-License-Identifier: BSL-1.0
// rivals: the same samples in biaxial tests with each model of breakage, calibrated to one strength
// Every model begins with the same compacted samples, and a disc has the same Brazilian strength in
// all of them. Files of finished runs that the folder has already are kept, so that it can be
// stopped and continued.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <riprap/output/file.hpp>

#include "../command_line/program.hpp"
#include "../run_table/options.hpp"
#include "../run_table/tasks.hpp"
#include "report.hpp"
#include "sample.hpp"

namespace fs = std::filesystem;
using namespace rivals;

namespace {

struct Options : run_table::RunOptions {
  unsigned particles = 120;
  unsigned samples = 8;
  std::uint64_t seed = 1;  // of the first sample
  std::vector<double> pressures{2e6, 8e6};
  double strain = 0.1;
  double strength = 12e6;
  unsigned cells = 12;              // of a bonded particle
  std::vector<std::string> models;  // all of them, if empty
  bool quick = false;
};

struct Planned {
  std::size_t set;  // of a model and a pressure
  run_table::Task task;
};

run_table::Task run_task(const Options& o, const RivalModel& model, double pressure,
                         std::uint64_t seed) {
  const std::string name = std::string(model.name) + "_" + riprap::to_text(1e-6 * pressure) +
                           "MPa_seed_" + std::to_string(seed);
  char key[200];
  std::snprintf(key, sizeof key,
                "# %s, %u particles, strain %g, Brazilian strength %g Pa, %u cells", name.c_str(),
                o.particles, o.strain, o.strength, o.cells);
  return {fs::path(o.out) / "runs" / (name + ".json"), key, [o, &model, pressure, seed] {
            Case c{.sample = compacted_sample(o.particles, seed),
                   .pressure = pressure,
                   .strain = o.strain,
                   .strength = o.strength,
                   .cells = o.cells,
                   .seed = seed};
            c.diameter = mean_diameter(c.sample);
            return model.run(c).dump() + "\n";
          }};
}

std::vector<const RivalModel*> chosen(const Options& o) {
  std::vector<const RivalModel*> all;
  for (const RivalModel& model : all_models)
    if (o.models.empty() || std::ranges::find(o.models, model.name) != o.models.end())
      all.push_back(&model);
  return all;
}

int compare(const Options& o) {
  riprap::make_folder((fs::path(o.out) / "runs").string());
  std::vector<ModelRuns> sets;
  std::vector<run_table::Task> tasks;
  for (const double pressure : o.pressures)
    for (const RivalModel* model : chosen(o)) sets.push_back({model, pressure, {}});
  for (unsigned k = 0; k < o.samples; ++k)  // the first sample of all before the second
    for (const ModelRuns& set : sets)
      tasks.push_back(run_task(o, *set.model, set.pressure, o.seed + k));
  run_table::make_results(tasks, o.jobs);
  for (std::size_t k = 0; k < tasks.size(); ++k)
    sets[k % sets.size()].samples.push_back(
        Json::parse(run_table::result_of(tasks[k]).value_or("")));
  const std::string text = table(sets);
  riprap::write_file((fs::path(o.out) / "table.md").string(), text);
  charts(sets).save((fs::path(o.out) / "rivals.svg").string());
  std::fputs(text.c_str(), stdout);
  std::printf("%u samples; table.md, rivals.svg and the runs are in %s\n", o.samples,
              o.out.c_str());
  return command_line::finished;
}

}  // namespace

int main(int argc, char** argv) {
  Options o;
  o.out = "rivals";
  CLI::App app{"Biaxial tests of the same compacted samples with each model of breakage, all set "
               "to the same Brazilian\nstrength of a disc: curves, volume, coordination, "
               "breakages, grading, processor time."};
  std::vector<std::string> names;
  for (const RivalModel& model : all_models) names.emplace_back(model.name);
  app.add_option("--models", o.models, "some of them; all unless given")
      ->check(CLI::IsMember(names))
      ->delimiter(',');
  app.add_option("--particles", o.particles, "of a sample")
      ->capture_default_str()
      ->check(CLI::Range(20, 1000000));
  app.add_option("--samples", o.samples, "with seeds one apart")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_option("--seed", o.seed, "of the first sample")->capture_default_str();
  app.add_option("--pressure", o.pressures, "confining pressures [Pa]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber)
      ->delimiter(',');
  app.add_option("--strain", o.strain, "axial, at the end of shear")
      ->capture_default_str()
      ->check(CLI::Range(0.001, 0.8));
  app.add_option("--strength", o.strength, "Brazilian, of a disc of the mean diameter [Pa]")
      ->capture_default_str()
      ->check(CLI::PositiveNumber);
  app.add_option("--cells", o.cells, "of a bonded particle")
      ->capture_default_str()
      ->check(CLI::Range(2, 1000));
  run_table::add_options(app, o, "runs");
  app.add_flag("--quick", o.quick, "one small sample to 1 % strain, as a trial");
  command_line::parse_or_exit(app, [&] { app.parse(argc, argv); });
  if (o.quick) {
    o.particles = 60;
    o.samples = 1;
    o.strain = 0.01;
  }
  return command_line::run_program({}, [&] { return compare(o); });
}
