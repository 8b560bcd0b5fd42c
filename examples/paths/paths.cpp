// SPDX-License-Identifier: BSL-1.0
// paths: tests along ready-made loading paths, or along that of a file, with curves and pictures

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <filesystem>

#include <riprap/core/version.hpp>
#include <riprap/output/chart.hpp>
#include <riprap/output/file.hpp>
#include <riprap/particle/random_placement.hpp>

#include "../command_line/checkpoints.hpp"
#include "../command_line/program.hpp"
#include "test_case.hpp"

namespace paths {

namespace {

namespace fs = std::filesystem;

Json stages_json(const Run& run) {
  Json stages = Json::array();
  for (std::size_t k = 0; k < run.stages.size(); ++k) {
    const riprap::StageResult& stage = run.stages[k];
    stages.push_back({{"name", run.plan.stages[k].name},
                      {"steps", stage.steps},
                      {"reached_target", stage.reached_target},
                      {"mean_error", stage.mean_error},
                      {"rms_error", stage.rms_error},
                      {"last_error", stage.last_error},
                      {"wall_s", stage.wall_seconds}});
  }
  return stages;
}

Json run_json(const Run& run) {
  Json j = {{"name", run.plan.name()},
            {"seed", run.plan.sample.seed},
            {"particles", run.plan.sample.particles},
            {"compressive_strength_Pa", run.plan.sample.strength},
            {"breakage", run.plan.sample.breakage},
            {"contact_stiffness_N_m", run.plan.sample.stiffness},
            {"pressure_Pa", run.plan.pressure},
            {"breakages_before_loading", run.breakages_before},
            {"breakages", nullptr},
            {"energy_error", nullptr},
            {"stages", stages_json(run)},
            {"warnings", run.warnings}};
  if (!run.points.empty()) {
    j["breakages"] = run.points.back().breakages;
    j["energy_error"] = run.points.back().energy_error();
  }
  return j;
}

// Runs of an earlier command with other variants or seeds go.
void empty_folder(const fs::path& folder) {
  riprap::make_folder(folder.string());
  fs::remove_all(folder / "runs");
  for (const char* name : {"summary.json", "curves.svg"}) fs::remove(folder / name);
}

command_line::Saving saving_of(const PlannedRun& run, const fs::path& folder, const Options& o) {
  return {.folder = folder / "runs" / run.name(),
          .every = o.checkpoint_every,
          .given = {.toml = o.toml},
          .resumed = o.out};
}

// The tests that the options name; strings are to outlive them.
std::vector<TestCase> chosen_tests(const Options& o, const std::string& name,
                                   const std::string& what) {
  std::vector<TestCase> chosen;
  if (o.reads_file())
    chosen.push_back({name.c_str(), what.c_str(), plan_from_file, find_from_file});
  for (const TestCase& test : test_cases)
    if (o.test == test.name || o.test == "all") chosen.push_back(test);
  return chosen;
}

// Makes the folders, with what --resume needs. Throws InvalidInput before that for a test that
// cannot be made.
void begin(const std::vector<TestCase>& tests, const Options& o) {
  for (const TestCase& test : tests) static_cast<void>(test.plan(o));
  std::vector<std::byte> path;
  if (o.reads_file()) path = riprap::read_whole_file(o.test);
  for (const TestCase& test : tests) empty_folder(fs::path(o.out) / test.name);
  if (o.reads_file()) riprap::write_durable_file(o.path_copy().string(), path);
  command_line::write_parameters(o.toml, o.out);
}

// False: a signal ended it.
bool run_case(const TestCase& test, const Options& o) {
  const fs::path folder = fs::path(o.out) / test.name;
  const std::vector<PlannedRun> plan = test.plan(o);
  const auto clear_checkpoints = [&] {
    for (const PlannedRun& run : plan) saving_of(run, folder, o).checkpoints().clear();
  };
  if (!o.resume.empty() && fs::exists(folder / "summary.json")) {
    clear_checkpoints();
    std::printf("the test in %s is finished\n", folder.string().c_str());
    return true;
  }
  std::vector<Run> runs;
  run_table::ProgressLine progress(static_cast<double>(plan.size()));
  for (const PlannedRun& planned : plan) {
    const command_line::Saving saving = saving_of(planned, folder, o);
    riprap::make_folder(saving.folder.string());
    runs.push_back(run_path(planned, saving, progress));
    if (runs.back().interrupted) return false;
  }
  progress.end();

  const Findings findings = test.find(o, runs);
  riprap::chart_sheet(findings.charts).save((folder / "curves.svg").string());
  Json all = Json::array();
  for (const Run& run : runs) all.push_back(run_json(run));
  const Json summary = {{"riprap", riprap::version},
                        {"test", test.name},
                        {"samples", o.samples},
                        {"first_seed", o.seed},
                        {"quick", o.quick},
                        {"found", findings.numbers},
                        {"runs", all}};
  riprap::write_file((folder / "summary.json").string(), summary.dump(2) + "\n");
  clear_checkpoints();
  std::printf("%s\n", test.what);
  for (const std::string& line : findings.lines) std::printf("  %s\n", line.c_str());
  std::size_t warnings = 0;
  for (const Run& run : runs) warnings += run.warnings.size();
  std::printf("curves.svg, summary.json (%zu warnings) and a folder for each run in %s\n", warnings,
              folder.string().c_str());
  return true;
}

int run_chosen(const Options& o) {
  if (o.test.empty()) {
    for (const TestCase& test : test_cases) std::printf("  %-12s %s\n", test.name, test.what);
    std::printf("  %-12s all of them, one after the other\n", "all");
    std::printf("  %-12s the path of a file (docs/paths.md)\n", "FILE.toml");
    return command_line::finished;
  }
  // Before a folder is made.
  riprap::RandomAssembly{.count = o.particles, .seed = o.seed}.validate();
  command_line::note_signals();
  const std::string name = o.path_copy().parent_path().filename().string();
  const std::string what = "the path of " + o.test;
  const std::vector<TestCase> tests = chosen_tests(o, name, what);
  if (o.resume.empty()) begin(tests, o);
  for (const TestCase& test : tests)
    if (!run_case(test, o)) {
      std::fprintf(stderr, "interrupted; the curves until then are in %s\n", o.out.c_str());
      return command_line::failed;
    }
  return command_line::finished;
}

}  // namespace

}  // namespace paths

int main(int argc, char** argv) {
  std::vector<std::string> names;
  for (const paths::TestCase& test : paths::test_cases) names.push_back(test.name);
  const paths::Options options = paths::read_options(argc, argv, names);
  return command_line::run_program(options.names, [&] { return paths::run_chosen(options); });
}
