// SPDX-License-Identifier: BSL-1.0
// sensitivity: biaxial tests with other time steps, rates, sizes, intervals of checks and damping
// One factor at a time. Runs that the folder has already are kept, so that a study can be stopped
// and continued.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <riprap/output/file.hpp>

#include "../command_line/program.hpp"
#include "../run_table/options.hpp"
#include "../run_table/run_biaxial.hpp"
#include "../run_table/tasks.hpp"

namespace fs = std::filesystem;

namespace {

struct Options : run_table::RunOptions {
  double pressure = 8;  // [MPa]
  unsigned samples = 4;
  unsigned particles = 500;
  double strain = 0.2;
  bool quick = false;
};

// What the table varies, beside the setup of the test.
struct Variant {
  std::string factor;
  std::string value;
  run_table::Setup setup;  // but for the seed
  unsigned samples = 1;
  double time_step = 1;  // times the model's own
  unsigned check_every = 1;
  double damping = riprap::LocalDamping{}.coefficient;

  // In runs of the base case.
  [[nodiscard]] double cost(const Options& o) const {
    return static_cast<double>(setup.particles) / o.particles *
           riprap::BiaxialTest{}.inertial_number / setup.inertial_number / time_step;
  }
};

// The base case first.
std::vector<Variant> variants(const Options& o) {
  const Variant base{
      .factor = "base case",
      .value = "",
      .setup = {.pressure = 1e6 * o.pressure, .particles = o.particles, .strain = o.strain},
      .samples = o.samples};
  std::vector<Variant> all{base};
  const auto add = [&](const std::string& factor, const std::string& value) -> Variant& {
    all.push_back(base);
    all.back().factor = factor;
    all.back().value = value;
    return all.back();
  };
  for (const double times : {0.5, 2.0})
    add("time step", "x " + riprap::to_text(times)).time_step = times;
  for (const double times : {0.25, 0.5, 2.0})
    add("inertial number", "x " + riprap::to_text(times)).setup.inertial_number *= times;
  for (const unsigned times : {3U, 10U}) {
    Variant& v = add("particles", std::to_string(times * o.particles));
    v.setup.particles *= times;
    v.samples = std::max(1U, o.samples / (times == 3 ? 2 : 4));
  }
  for (const unsigned steps : {10U, 100U})
    add("steps between checks", std::to_string(steps)).check_every = steps;
  for (const double coefficient : {0.3, 0.5, 0.8})
    add("local damping", riprap::to_text(coefficient)).damping = coefficient;
  return all;
}

// Named, so that the table stays that of this law whatever the defaults are.
auto base_model() {
  return riprap::Model{}
      .narrow_phase(riprap::OverlapMoments{})
      .contact_law(riprap::EnergyConservingSpring{});
}

riprap::MassFloor time_step(const Variant& v) {
  riprap::MassFloor step = base_model().motion_model.time_step;
  step.fraction *= v.time_step;
  return step;
}

run_table::Task task(const Variant& v, unsigned seed, const fs::path& folder) {
  run_table::Setup setup = v.setup;
  setup.seed = seed;
  char key[240];
  std::snprintf(
      key, sizeof key,
      "# OverlapMoments, EnergyConservingSpring, %g MPa, seed %u, %u particles, strain %g, "
      "inertial number %g, time step %g, check every %u, damping %g",
      1e-6 * setup.pressure, seed, setup.particles, setup.strain, setup.inertial_number,
      time_step(v).fraction, v.check_every, v.damping);
  std::string name = v.factor + (v.value.empty() ? "" : "_" + v.value) + "_" + std::to_string(seed);
  std::ranges::replace(name, ' ', '_');
  return {folder / (name + ".csv"), key, [v, setup] {
            const auto model = base_model()
                                   .time_step(time_step(v))
                                   .damping(riprap::LocalDamping{.coefficient = v.damping})
                                   .check_every(v.check_every);
            return to_lines(run_table::run_biaxial(model, setup));
          }};
}

int tabulate(const Options& o) {
  riprap::make_folder(o.out);
  const std::vector<Variant> all = variants(o);
  std::vector<const Variant*> short_first;
  for (const Variant& v : all) short_first.push_back(&v);
  std::ranges::stable_sort(short_first, {}, [&](const Variant* v) { return v->cost(o); });
  std::vector<run_table::Task> tasks;
  for (const Variant* v : short_first)
    for (unsigned seed = 1; seed <= v->samples; ++seed) tasks.push_back(task(*v, seed, o.out));
  run_table::make_results(tasks, o.jobs);

  std::vector<run_table::Row> rows;
  for (const Variant& v : all) {
    rows.push_back({v.factor + " | " + v.value + " | " + std::to_string(v.samples)});
    for (unsigned seed = 1; seed <= v.samples; ++seed)
      rows.back().runs.push_back(run_table::numbers_of(task(v, seed, o.out)));
  }
  run_table::leave_table(o.out, {"factor", "value", "samples"}, rows);
  return command_line::finished;
}

}  // namespace

int main(int argc, char** argv) {
  Options o;
  o.out = "sensitivity";
  CLI::App app{"Biaxial tests with one numerical parameter at a time other than in the base case. "
               "Mean and standard deviation of the samples; energies as shares of the boundary "
               "work, what is made is negative."};
  app.add_option("--pressure", o.pressure, "confining pressure [MPa]")->capture_default_str();
  app.add_option("--samples", o.samples, "seeds 1, 2, ...; fewer of larger samples")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  app.add_option("--particles", o.particles, "of the base case; 3 and 10 times as many are tried")
      ->capture_default_str();
  app.add_option("--strain", o.strain, "axial strain of shear")->capture_default_str();
  run_table::add_options(app, o, "runs");
  app.add_flag("--quick", o.quick, "one sample of 40 particles to a strain of 0.002, as a trial");
  command_line::parse_or_exit(app, [&] { app.parse(argc, argv); });
  if (o.quick) {
    o.samples = 1;
    o.particles = 40;
    o.strain = 0.002;
  }
  return command_line::run_program({}, [&] { return tabulate(o); });
}
