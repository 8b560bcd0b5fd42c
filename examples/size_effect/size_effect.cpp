// SPDX-License-Identifier: BSL-1.0
// size_effect: strength and envelope of samples whose particles are weaker the larger they are

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <riprap/measurement/strength_envelope.hpp>
#include <riprap/output/chart.hpp>
#include <riprap/output/file.hpp>
#include <riprap/riprap.hpp>

#include "../command_line/option_table.hpp"
#include "../command_line/program.hpp"
#include "../run_table/options.hpp"
#include "../run_table/tasks.hpp"
#include "../study/statistics.hpp"

namespace {

using namespace riprap;
namespace fs = std::filesystem;

struct Options : run_table::RunOptions {
  WeibullStrength strength{.modulus = 4, .dimension = 3};
  double reference_diameter = 0.016;  // at which the strength is that of the criterion [m]
  unsigned particles = 300;
  double strain = 0.15;
  std::uint64_t seed = 1;
  unsigned samples = 2;
  std::vector<double> diameters{0.004, 0.016, 0.064};
  std::vector<double> pressures{1e6, 4e6, 16e6};
  bool quick = false;

  // Of a particle over that of the criterion [-].
  [[nodiscard]] double strength_of(double diameter) const {
    return std::pow(diameter / reference_diameter, -strength.dimension / strength.modulus);
  }
};

struct Test {
  double diameter = 0;  // mean, of the particles [m]
  double pressure = 0;  // [Pa]
  std::uint64_t seed = 1;
};
struct Result {
  double sin_phi = 0;  // largest mean of five records [-]
  double breaks = 0;   // in shear, per particle [-]
};

[[nodiscard]] Result run(const Test& t, const Options& o) {
  // One thickness: but for the strengths, samples of one seed are drawn larger or smaller.
  WeibullStrength strength = o.strength;
  strength.seed = t.seed;
  Simulation sim{
      Model{}.trigger(strength),
      random_assembly({.count = o.particles, .mean_diameter = t.diameter, .seed = t.seed}), Rock{}};
  Curve curve;
  BiaxialTest{.confining_pressure = t.pressure, .axial_strain = o.strain}.run(sim, curve);
  std::vector<double> sin_phi;
  for (const CurvePoint& p : curve.points()) sin_phi.push_back(p.sin_phi());
  return {.sin_phi = run_study::largest_mean(sin_phi, 5),
          .breaks = static_cast<double>(curve.points().back().breakages) / o.particles};
}

// All tests of one diameter, pressure by pressure.
struct OfDiameter {
  double diameter = 0;
  std::vector<std::vector<Result>> of_pressure{};

  // The secant strengths of all tests.
  [[nodiscard]] std::vector<SecantStrength> strengths(const Options& o) const {
    std::vector<SecantStrength> all;
    for (std::size_t p = 0; p < of_pressure.size(); ++p)
      for (const Result& r : of_pressure[p])
        all.push_back(secant_strength(r.sin_phi, o.pressures[p]));
    return all;
  }
  template <class Value>
  [[nodiscard]] run_study::Statistics of(std::size_t pressure, Value&& value) const {
    std::vector<double> values;
    for (const Result& r : of_pressure[pressure]) values.push_back(value(r));
    return run_study::statistics_of(values);
  }
};

constexpr auto angle = [](const Result& r) {
  return std::asin(r.sin_phi) * 180 / std::numbers::pi;
};
constexpr auto breaks = [](const Result& r) { return r.breaks; };

[[nodiscard]] run_table::Task task_of(const Test& t, const Options& o) {
  std::ostringstream key;
  key.precision(17);
  key << "# d " << t.diameter << " m, " << t.pressure << " Pa, sample and strengths of seed "
      << t.seed << ", modulus " << o.strength.modulus << ", dimension " << o.strength.dimension
      << ", reference " << o.reference_diameter << " m, " << o.particles << " particles, strain "
      << o.strain;
  char name[80];
  std::snprintf(name, sizeof name, "d=%gmm_p=%gMPa_seed=%llu.txt", 1e3 * t.diameter,
                1e-6 * t.pressure, static_cast<unsigned long long>(t.seed));
  return {fs::path(o.out) / name, key.str(), [t, o] {
            const Result r = run(t, o);
            char line[80];
            std::snprintf(line, sizeof line, "%.17g %.17g\n", r.sin_phi, r.breaks);
            return std::string(line);
          }};
}

[[nodiscard]] std::vector<OfDiameter> make_tests(const Options& o) {
  std::vector<run_table::Task> tasks;
  for (unsigned s = 0; s < o.samples; ++s)
    for (const double d : o.diameters)
      for (const double p : o.pressures) tasks.push_back(task_of({d, p, o.seed + s}, o));
  run_table::make_results(tasks, o.jobs);
  std::vector<OfDiameter> all;
  for (const double d : o.diameters) {
    all.push_back({.diameter = d, .of_pressure = {}});
    for (const double p : o.pressures) {
      auto& results = all.back().of_pressure.emplace_back();
      for (unsigned s = 0; s < o.samples; ++s) {
        Result r;
        std::istringstream(run_table::result_of(task_of({d, p, o.seed + s}, o)).value_or("")) >>
            r.sin_phi >> r.breaks;
        results.push_back(r);
      }
    }
  }
  return all;
}

[[nodiscard]] std::string table(const std::vector<OfDiameter>& all, const Options& o) {
  std::string text =
      "mean_diameter_m,pressure_Pa,samples,particle_strength,friction_angle_degrees,sd,"
      "breaks_per_particle,sd\n";
  for (const OfDiameter& d : all)
    for (std::size_t p = 0; p < o.pressures.size(); ++p) {
      const auto phi = d.of(p, angle);
      const auto broken = d.of(p, breaks);
      const double strength = o.strength_of(d.diameter);
      for (const double value : {d.diameter, o.pressures[p], static_cast<double>(o.samples),
                                 strength, phi.mean, phi.standard_deviation, broken.mean})
        text += to_text(value) + ",";
      text += to_text(broken.standard_deviation) + "\n";
    }
  return text;
}

[[nodiscard]] Svg charts(const std::vector<OfDiameter>& all, const Options& o) {
  const char* colours[] = {"#8a5a1c", "#4b8ab0", "#1f4f7f", "#7f8f5a"};
  std::vector<Chart> sheet{
      {.title = "Envelope",
       .x_label = "normal stress [MPa]",
       .y_label = "secant friction angle [degrees]",
       .series = {},
       .x_scale = AxisScale::logarithmic},
      {.title = "Strength against size",
       .x_label = "mean diameter [mm]",
       .y_label = "friction angle at the peak [degrees]",
       .series = {},
       .x_scale = AxisScale::logarithmic},
      {.title = "Breakages in shear",
       .x_label = "confining pressure over strength factor of the mean particle [MPa]",
       .y_label = "per particle [-]",
       .series = {},
       .x_scale = AxisScale::logarithmic}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    const OfDiameter& d = all[k];
    const std::string name = to_text(1e3 * d.diameter) + " mm";
    const std::string colour = colours[k % std::size(colours)];
    Series envelope{.name = name, .points = {}, .colour = colour, .mark = Mark::circle};
    Series broken = envelope;
    const double strength = o.strength_of(d.diameter);
    for (std::size_t p = 0; p < o.pressures.size(); ++p) {
      const auto phi = d.of(p, angle);
      const double sin_phi = std::sin(phi.mean * std::numbers::pi / 180);
      envelope.points.push_back({1e-6 * o.pressures[p] * (1 + sin_phi), phi.mean});
      broken.points.push_back({1e-6 * o.pressures[p] / strength, d.of(p, breaks).mean});
    }
    sheet[0].series.push_back(std::move(envelope));
    sheet[2].series.push_back(std::move(broken));
  }
  for (std::size_t p = 0; p < o.pressures.size(); ++p) {
    Series series{.name = to_text(1e-6 * o.pressures[p]) + " MPa",
                  .points = {},
                  .colour = colours[p % std::size(colours)],
                  .mark = Mark::circle};
    for (const OfDiameter& d : all) {
      const auto phi = d.of(p, angle);
      series.points.push_back({1e3 * d.diameter, phi.mean});
      series.y_errors.push_back(phi.count > 1 ? phi.standard_deviation : 0);
    }
    sheet[1].series.push_back(std::move(series));
  }
  return chart_sheet(sheet);
}

void print(const std::vector<OfDiameter>& all, const Options& o) {
  std::printf("diameter [mm]  strength  friction angle [degrees] (breaks per particle) at "
              "pressure, and envelope\n");
  for (const OfDiameter& d : all) {
    std::printf("%-13g  %-8.3f", 1e3 * d.diameter, o.strength_of(d.diameter));
    for (std::size_t p = 0; p < o.pressures.size(); ++p)
      std::printf("  %g MPa: %.1f (%.2f)", 1e-6 * o.pressures[p], d.of(p, angle).mean,
                  d.of(p, breaks).mean);
    const PowerLawEnvelope fit = fit_power_law(d.strengths(o), 1e6);
    std::printf("  tau = %.3f sigma^%.3f [MPa]\n", fit.coefficient, fit.exponent);
  }
}

int study(Options o) {
  require(o.samples >= 1, "samples", o.samples, "must be 1 or more");
  require_positive("reference diameter", o.reference_diameter);
  o.strength.reference_area = 0.25 * std::numbers::pi * o.reference_diameter * o.reference_diameter;
  o.strength.validate();
  make_folder(o.out);
  const std::vector<OfDiameter> all = make_tests(o);
  write_file(fs::path(o.out) / "summary.csv", table(all, o));
  charts(all, o).save(fs::path(o.out) / "size_effect.svg");
  print(all, o);
  std::printf("means of %u samples; table and picture in %s\n", o.samples, o.out.c_str());
  return command_line::finished;
}

}  // namespace

int main(int argc, char** argv) {
  Options o;
  o.out = "size_effect";
  CLI::App app{"Biaxial tests of samples of small and large particles, whose strengths scatter and "
               "fall with\nsize d as d^(-dimension / modulus). Finished tests in the folder are "
               "kept: stop it, and go on\nwith the same command."};
  app.get_formatter()->column_width(42);
  command_line::OptionTable table(app);
  table.add_number("--modulus", o.strength.modulus, "WeibullStrength.modulus", "of Weibull [-]");
  table.add_number("--dimension", o.strength.dimension, "WeibullStrength.dimension",
                   "3: flaws by volume, 2: by area, 0: no size effect [-]");
  table.add_number("--reference", o.reference_diameter, "reference diameter",
                   "whose characteristic strength is that of the criterion [m]");
  table.add_number("--particles", o.particles, "RandomAssembly.count", "in each sample");
  table.add_number("--strain", o.strain, "BiaxialTest.axial_strain", "axial, at the end [-]");
  table.add_number("--seed", o.seed, "RandomAssembly.seed", "of the first sample");
  table.add_number("--samples", o.samples, "samples", "of each diameter, of seeds one apart");
  table.add_flag("--quick", o.quick, "few particles, two diameters: an example of the output");
  run_table::add_options(app, o, "tests");
  command_line::parse_or_exit(app, [&] { app.parse(argc, argv); });
  if (o.quick) {
    o.particles = 80;
    o.strain = 0.02;
    o.samples = 1;
    o.diameters = {0.004, 0.064};
    o.pressures = {4e6, 16e6};
  }
  return command_line::run_program(table.names(), [&] { return study(o); });
}
