// SPDX-License-Identifier: BSL-1.0
// two_rocks: biaxial tests of mixtures of strong and weak rock: strength, volume, breakage of each

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <riprap/output/chart.hpp>
#include <riprap/output/file.hpp>

#include "../command_line/option_table.hpp"
#include "../command_line/program.hpp"
#include "../run_table/options.hpp"
#include "../run_table/tasks.hpp"
#include "../shear_tests/results.hpp"
#include "../study/statistics.hpp"
#include "mixture.hpp"

namespace {

using namespace two_rocks;
using riprap::Vec2;
using run_study::Statistics;
namespace fs = std::filesystem;

struct Options : run_table::RunOptions {
  Mixture mixture{.weak_rock = {.compressive_strength = 60e6,
                                .m_b = 17,
                                .young = 20e9,
                                .poisson = 0.25,
                                .density = 2300}};
  unsigned samples = 3;
  std::vector<double> shares{0, 0.25, 0.5, 0.75, 1};
  bool quick = false;
};

// The tests of one share.
struct ShareResult {
  double share = 0;
  std::vector<std::vector<MixtureRecord>> tests{};

  // Of a number of each test.
  template <class Value>
  [[nodiscard]] Statistics of(Value&& value) const {
    std::vector<double> values;
    for (const auto& records : tests) values.push_back(value(records));
    return run_study::statistics_of(values);
  }
  // The mean over the tests of a number of each record, to the end of the shortest test.
  template <class Value>
  [[nodiscard]] std::vector<Vec2> curve(Value&& value) const {
    std::vector<std::vector<Vec2>> curves;
    for (const auto& records : tests) {
      curves.emplace_back();
      for (const auto& r : records) curves.back().push_back({100 * r.strain, value(r)});
    }
    return shear_tests::mean_curve(curves);
  }
};

constexpr auto peak = [](const auto& records) { return strength_of(records).peak; };
constexpr auto at_end = [](const auto& records) { return strength_of(records).end; };
constexpr auto volume = [](const auto& records) { return 100 * records.back().volumetric_strain; };
constexpr auto breaks_of(Material m) {
  return [m](const auto& records) { return records.back().breaks[m]; };
}
constexpr auto hardin_of(Material m) {
  return [m](const auto& records) { return records.back().hardin[m]; };
}

std::vector<ShareResult> make_tests(const Options& o) {
  std::vector<run_table::Task> tasks;
  for (unsigned s = 0; s < o.samples; ++s)
    for (const double share : o.shares) {
      Mixture m = o.mixture;
      m.weak_share = share;
      m.seed = o.mixture.seed + s;
      char name[60];
      std::snprintf(name, sizeof name, "weak_%03.0f_seed_%llu", 100 * share,
                    static_cast<unsigned long long>(m.seed));
      const fs::path picture = s == 0 ? fs::path(o.out) / (name + std::string(".svg")) : fs::path();
      tasks.push_back({fs::path(o.out) / (name + std::string(".txt")), key_of(m),
                       [m, picture] { return to_lines(run(m, picture)); }});
    }
  run_table::make_results(tasks, o.jobs);
  std::vector<ShareResult> all;
  for (const double share : o.shares) all.push_back({.share = share});
  for (std::size_t k = 0; k < tasks.size(); ++k)
    all[k % all.size()].tests.push_back(
        from_lines(run_table::result_of(tasks[k]).value_or(std::string())));
  return all;
}

std::string table(const std::vector<ShareResult>& all) {
  std::string text =
      "weak_share,samples,sin_phi_peak,sd,sin_phi_end,sd,volumetric_strain_percent,sd,"
      "breaks_strong,sd,breaks_weak,sd,hardin_strong,sd,hardin_weak,sd\n";
  for (const ShareResult& r : all) {
    text += riprap::to_text(r.share) + "," + std::to_string(r.tests.size());
    const Statistics numbers[] = {r.of(peak),
                                  r.of(at_end),
                                  r.of(volume),
                                  r.of(breaks_of(strong)),
                                  r.of(breaks_of(weak)),
                                  r.of(hardin_of(strong)),
                                  r.of(hardin_of(weak))};
    for (const Statistics& s : numbers)
      text += "," + riprap::to_text(s.mean) + "," + riprap::to_text(s.standard_deviation);
    text += "\n";
  }
  return text;
}

riprap::Svg charts(const std::vector<ShareResult>& all) {
  const char* colours[] = {"#8a5a1c", "#c28a3c", "#7f8f5a", "#4b8ab0", "#1f4f7f"};
  const std::string of_share = "share of weak rock [%]";
  std::vector<riprap::Chart> sheet{
      {"Stress ratio", "axial strain [%]", "sin phi [-]", {}},
      {"Volume", "axial strain [%]", "volumetric strain, contraction positive [%]", {}},
      {"Strength", of_share, "sin phi [-]", {}},
      {"Breakages in shear", of_share, "per sample [-]", {}},
      {"Hardin's index at the end", of_share, "B_r of the rock [-]", {}}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    const std::string name = riprap::to_text(100 * all[k].share) + " % weak";
    const std::string colour = colours[k % std::size(colours)];
    sheet[0].series.push_back(
        {name, all[k].curve([](const auto& r) { return r.sin_phi; }), colour});
    sheet[1].series.push_back(
        {name, all[k].curve([](const auto& r) { return 100 * r.volumetric_strain; }), colour});
  }
  const auto add = [&](std::size_t chart, const std::string& name, const std::string& colour,
                       const auto& value) {
    riprap::Series series{
        .name = name, .points = {}, .colour = colour, .mark = riprap::Mark::circle};
    for (const ShareResult& r : all) {
      const Statistics s = r.of(value);
      if (s.count == 0) continue;
      series.points.push_back({100 * r.share, s.mean});
      series.y_errors.push_back(s.count > 1 ? s.standard_deviation : 0);
    }
    sheet[chart].series.push_back(std::move(series));
  };
  add(2, "peak", "#1f4f7f", peak);
  add(2, "last quarter", "#c28a3c", at_end);
  add(3, "strong rock", "#b0803a", breaks_of(strong));
  add(3, "weak rock", "#2f6f9f", breaks_of(weak));
  add(4, "strong rock", "#b0803a", hardin_of(strong));
  add(4, "weak rock", "#2f6f9f", hardin_of(weak));
  return riprap::chart_sheet(sheet);
}

void print(const std::vector<ShareResult>& all) {
  std::printf(
      "weak [%%]  sin phi, peak    last quarter     volume [%%]       breaks strong, weak   "
      "B_r strong, weak\n");
  const auto cell = [](const Statistics& s, int decimals) {
    char text[60];
    if (s.count == 0) return std::string("-");
    if (s.count == 1)
      std::snprintf(text, sizeof text, "%.*f", decimals, s.mean);
    else
      std::snprintf(text, sizeof text, "%.*f +- %.*f", decimals, s.mean, decimals,
                    s.standard_deviation);
    return std::string(text);
  };
  for (const ShareResult& r : all)
    std::printf("%-9g %-16s %-16s %-16s %-11s %-11s %-14s %s\n", 100 * r.share,
                cell(r.of(peak), 3).c_str(), cell(r.of(at_end), 3).c_str(),
                cell(r.of(volume), 2).c_str(), cell(r.of(breaks_of(strong)), 0).c_str(),
                cell(r.of(breaks_of(weak)), 0).c_str(), cell(r.of(hardin_of(strong)), 3).c_str(),
                cell(r.of(hardin_of(weak)), 3).c_str());
}

int study(const Options& o) {
  riprap::make_folder(o.out);
  const std::vector<ShareResult> all = make_tests(o);
  riprap::write_file(fs::path(o.out) / "summary.csv", table(all));
  charts(all).save(fs::path(o.out) / "two_rocks.svg");
  print(all);
  std::printf("mean +- standard deviation of %u samples; tables and pictures in %s\n", o.samples,
              o.out.c_str());
  return command_line::finished;
}

void add_rock(command_line::OptionTable& table, const std::string& prefix, const std::string& name,
              RockOfSample& rock) {
  table.begin_group(name);
  const auto add = [&](const char* option, double& value, const char* member, const char* text) {
    table.add_number("--" + prefix + option, value, member, text);
  };
  add("compressive-strength", rock.compressive_strength, "HoekBrown.compressive_strength",
      "uniaxial [Pa]");
  add("m-b", rock.m_b, "HoekBrown.m_b", "of Hoek and Brown [-]");
  add("young", rock.young, "Rock.young", "Young's modulus [Pa]");
  add("poisson", rock.poisson, "Rock.poisson", "Poisson's ratio [-]");
  add("density", rock.density, "Rock.density", "[kg/m^3]");
  add("friction", rock.friction, "EnergyConservingSpring.friction",
      "of contacts of this rock; of two rocks the smaller one [-]");
}

}  // namespace

int main(int argc, char** argv) {
  Options o;
  o.out = "two_rocks";
  CLI::App app{"Biaxial tests of samples with 0, 25, 50, 75 and 100 % of weak rock, by area. The "
               "samples of one seed\nhave the same particles. Finished tests in the folder are "
               "kept: stop it, and go on with the same command."};
  app.get_formatter()->column_width(42);
  command_line::OptionTable table(app);
  table.begin_group("Tests");
  table.add_number("--particles", o.mixture.particles, "RandomAssembly.count", "in each sample");
  table.add_number("--pressure", o.mixture.pressure, "BiaxialTest.confining_pressure", "[Pa]");
  table.add_number("--strain", o.mixture.strain, "BiaxialTest.axial_strain",
                   "axial, at the end [-]");
  table.add_number("--seed", o.mixture.seed, "RandomAssembly.seed", "of the first sample");
  table.add_number("--samples", o.samples, "samples", "of each share, of seeds one apart");
  table.add_flag("--quick", o.quick, "few particles and three shares: an example of the output");
  add_rock(table, "strong-", "Strong rock", o.mixture.rock);
  add_rock(table, "weak-", "Weak rock", o.mixture.weak_rock);
  run_table::add_options(app, o, "tests");
  command_line::parse_or_exit(app, [&] { app.parse(argc, argv); });
  if (o.quick) {
    o.mixture.particles = 80;
    o.mixture.strain = 0.03;
    o.samples = 1;
    o.shares = {0, 0.5, 1};
  }
  return command_line::run_program(table.names(), [&] {
    riprap::require(o.samples >= 1, "samples", o.samples, "must be 1 or more");
    return study(o);
  });
}
