// SPDX-License-Identifier: BSL-1.0
// convergence: critical load and crack of particles against the mesh, under loads of biaxial tests
// Files of finished parts that the folder has already are kept, so that a study can be stopped and
// continued.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <riprap/output/file.hpp>

#include "../command_line/program.hpp"
#include "../run_table/options.hpp"
#include "../run_table/tasks.hpp"
#include "report.hpp"

namespace fs = std::filesystem;
using namespace convergence;

namespace {

struct Options : run_table::RunOptions {
  unsigned particles = 500;
  unsigned measured = 500;
  bool quick = false;
};

constexpr std::size_t part_size = 10;   // particles of a file
constexpr std::size_t fine_every = 20;  // particles from one that is measured on the fine mesh

struct Origin {
  std::string name;
  std::string file;
  Test test;
  bool plane_strain = false;
};

std::vector<Origin> origins(const Options& o) {
  std::vector<Origin> all;
  for (const double pressure : {2.0, 8.0, 14.0}) {
    const std::string text = riprap::to_text(pressure);
    all.push_back({text + " MPa", text + "MPa", {.pressure = 1e6 * pressure}, pressure == 8});
  }
  all.push_back(
      {"pieces, 14 MPa", "pieces_14MPa", {.pressure = 14e6, .strain = 0.1, .breakage = true}});
  if (o.quick) {
    all.resize(1);
    all[0].plane_strain = true;
  }
  for (Origin& origin : all) {
    origin.test.particles = o.particles;
    if (o.quick) origin.test.strain = 0.002;
  }
  return all;
}

run_table::Task sample_task(const Origin& origin, const fs::path& folder) {
  const Test& test = origin.test;
  char key[200];
  std::snprintf(
      key, sizeof key,
      "# OverlapMoments, EnergyConservingSpring, %g MPa, seed %llu, %u particles, strain %g, "
      "breakage %s",
      1e-6 * test.pressure, static_cast<unsigned long long>(test.seed), test.particles, test.strain,
      test.breakage ? "on" : "off");
  return {folder / ("particles_" + origin.file + ".txt"), key,
          [test] { return to_lines(loaded_particles(test)); }};
}

// Spread over the sample; the first ones of a larger count are those of a smaller one.
std::vector<std::size_t> chosen(const Sample& sample, std::size_t count) {
  const auto place = [](std::size_t i) {
    const double turns = static_cast<double>(i) / std::numbers::phi;
    return turns - std::floor(turns);
  };
  std::vector<std::size_t> numbers(sample.particles.size());
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  std::ranges::sort(numbers, {}, place);
  numbers.resize(std::min(count, numbers.size()));
  return numbers;
}

std::vector<run_table::Task> measurement_tasks(const Origin& origin, const Sample& sample,
                                               const Options& o) {
  const std::vector<std::size_t> numbers = chosen(sample, o.measured);
  std::vector<run_table::Task> tasks;
  for (std::size_t first = 0; first < numbers.size(); first += part_size) {
    const std::size_t last = std::min(first + part_size, numbers.size());
    char part[40];
    std::snprintf(part, sizeof part, "_%03zu.csv", first / part_size);
    const std::string key = sample_task(origin, o.out).key + ", particles " +
                            std::to_string(first) + " to " + std::to_string(last) + ", limits" +
                            limits_text();
    tasks.push_back({fs::path(o.out) / ("strength_" + origin.file + part), key,
                     [&sample, numbers, first, last, strain = origin.plane_strain] {
                       std::vector<Measurement> all;
                       for (std::size_t k = first; k < last; ++k) {
                         const Extent extent{.fine_mesh = k % fine_every == 0,
                                             .plane_strain = strain};
                         const auto one = measure(sample.particles[numbers[k]], sample, extent);
                         all.insert(all.end(), one.begin(), one.end());
                       }
                       return to_lines(all);
                     }});
  }
  return tasks;
}

int study(const Options& o) {
  riprap::make_folder(o.out);
  const std::vector<Origin> all = origins(o);
  std::vector<run_table::Task> sampling;
  // Longest first.
  for (auto origin = all.rbegin(); origin != all.rend(); ++origin)
    sampling.push_back(sample_task(*origin, o.out));
  run_table::make_results(sampling, o.jobs);

  std::vector<Sample> samples;
  for (const Origin& origin : all)
    samples.push_back(sample_from(run_table::result_of(sample_task(origin, o.out)).value_or("")));
  std::vector<run_table::Task> tasks;
  std::vector<MeasuredSet> sets;
  std::vector<std::size_t> set_of;
  for (std::size_t i = 0; i < all.size(); ++i) {
    sets.push_back({all[i].name, all[i].test.breakage, all[i].plane_strain});
    for (run_table::Task& task : measurement_tasks(all[i], samples[i], o)) {
      tasks.push_back(std::move(task));
      set_of.push_back(i);
    }
  }
  run_table::make_results(tasks, o.jobs);
  for (std::size_t k = 0; k < tasks.size(); ++k) {
    const auto part = measurements_from(run_table::result_of(tasks[k]).value_or(""));
    auto& into = sets[set_of[k]].measurements;
    into.insert(into.end(), part.begin(), part.end());
  }
  const std::string text = tables(sets);
  riprap::write_file((fs::path(o.out) / "tables.md").string(), text);
  charts(sets).save((fs::path(o.out) / "convergence.svg").string());
  std::fputs(text.c_str(), stdout);
  return command_line::finished;
}

}  // namespace

int main(int argc, char** argv) {
  Options o;
  o.out = "convergence";
  CLI::App app{
      "The load at which 0.4 of a particle's area has failed and its crack, on meshes of 25 "
      "to 800 points, beside those on a very fine mesh. Particles with three contacts or "
      "more from biaxial tests at 2, 8 and 14 MPa."};
  app.add_option("--particles", o.particles, "of a biaxial test")->capture_default_str();
  app.add_option("--measured", o.measured, "most particles of a test that are measured")
      ->capture_default_str()
      ->check(CLI::Range(1, 100000));
  run_table::add_options(app, o, "parts");
  app.add_flag("--quick", o.quick, "four particles of a small test, as a trial");
  command_line::parse_or_exit(app, [&] { app.parse(argc, argv); });
  if (o.quick) {
    o.particles = 60;
    o.measured = 4;
  }
  return command_line::run_program({}, [&] { return study(o); });
}
