// SPDX-License-Identifier: BSL-1.0
// attrition: particles sheared to large strain: mass that breaks off against strain, work and rate
// The test of Potapov and Campbell (1997), with stresses of finite elements in rigid particles.

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <riprap/output/file.hpp>

#include "../command_line/program.hpp"
#include "../shear_tests/cell_results.hpp"

namespace {

using namespace shear_tests;
using riprap::Vec2;
namespace fs = std::filesystem;

constexpr double faster = 10;  // the rate of the last series over that of the others

constexpr auto strain = [](const CellRecord& r) { return r.strain; };
constexpr auto work = [](const CellRecord& r) { return 1e-3 * r.work; };
constexpr auto detached = [](const CellRecord& r) { return 100 * r.detached; };
constexpr auto broken = [](const CellRecord& r) { return 100 * r.broken; };

// Mass detached against work [-, J/kg].
StraightLine line_of(const CellResult& r) {
  std::vector<Vec2> points;
  for (const CellRecord& rec : r.records) points.push_back({rec.work, rec.detached});
  return straight_line(points);
}
// n of detached ~ work^n, over the records from a tenth of the strain on in which mass is detached;
// not-a-number for less than ten.
double exponent(const CellResult& r) {
  std::vector<Vec2> logs;
  for (std::size_t i = r.records.size() / 10; i < r.records.size(); ++i)
    if (const CellRecord& rec = r.records[i]; rec.detached > 0 && rec.work > 0)
      logs.push_back({std::log(rec.work), std::log(rec.detached)});
  return logs.size() < 10 ? std::nan("") : straight_line(logs).line.slope;
}
double per_work(const CellResult& r) {
  return r.records.back().detached / (1e-3 * r.records.back().work);
}

std::vector<CellSeries> make_tests(const Options& o) {
  std::vector<CellPlan> plans;
  const auto add = [&](const std::string& name, double stress, double inertial_number) {
    plans.push_back(
        {name,
         {.normal_stress = stress, .inertial_number = inertial_number, .seed = o.assembly.seed}});
  };
  for (const double s : o.normal_stresses) add(stress_text(s), s, o.inertial_number);
  const double last = o.normal_stresses.back();
  add(stress_text(last) + ", fast", last, faster * o.inertial_number);
  return run_cells(o, plans);
}

Json summary(const Options& o, const std::vector<CellSeries>& all) {
  Json j = options_json(o);
  for (const CellSeries& s : all) {
    const auto at_end = [&](const auto& value) {
      return to_json(s.of([&](const CellResult& r) { return value(r.records.back()); }));
    };
    j["tests"].push_back(
        {{"name", s.name},
         {"normal_stress_Pa", s.results.front().test.normal_stress},
         {"inertial_number", s.results.front().test.inertial_number},
         {"shear_rate_1_s", s.results.front().rate},
         {"breakages", at_end([](const auto& r) { return static_cast<double>(r.breakages); })},
         {"broken", at_end([](const auto& r) { return r.broken; })},
         {"detached", at_end([](const auto& r) { return r.detached; })},
         {"work_J_kg", at_end([](const auto& r) { return r.work; })},
         {"detached_per_work_kg_kJ", to_json(s.of(per_work))},
         {"exponent_of_work", to_json(s.of(exponent))},
         {"r_squared_of_straight_line",
          to_json(s.of([](const auto& r) { return line_of(r).r_squared; }))}});
  }
  return j;
}

riprap::Svg charts(const std::vector<CellSeries>& all) {
  std::vector<riprap::Chart> sheet{
      {"Mass that has left its particle", "shear strain [-]", "of all mass [%]", {}},
      {"The same against the work of the cell", "work [kJ/kg]", "of all mass [%]", {}},
      {"Mass in pieces", "shear strain [-]", "of all mass [%]", {}},
      {"Shear over normal stress", "shear strain [-]", "on the plane of shear [-]", {}}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    const CellSeries& s = all[k];
    const bool fast = k + 1 == all.size();
    const auto add = [&](std::size_t chart, std::vector<Vec2> points) {
      sheet[chart].series.push_back({s.name, std::move(points), colour(fast ? k - 1 : k), fast});
    };
    add(0, s.curve(strain, detached));
    add(1, s.curve(work, detached));
    add(2, s.curve(strain, broken));
    add(3, s.curve(strain, [](const CellRecord& r) { return r.ratio(); }));
  }
  return riprap::chart_sheet(sheet);
}

void print(const std::vector<CellSeries>& all) {
  std::printf(
      "test          detached [%%]   in pieces [%%]  work [kJ/kg]   [%%] per kJ/kg    exponent\n");
  for (const CellSeries& s : all) {
    const auto at_end = [&](const auto& value) {
      return interval_text(s.of([&](const CellResult& r) { return value(r.records.back()); }), 2);
    };
    std::printf("%-12s  %-13s  %-13s  %-13s  %-15s  %s\n", s.name.c_str(), at_end(detached).c_str(),
                at_end(broken).c_str(), at_end(work).c_str(),
                interval_text(s.of([](const auto& r) { return 100 * per_work(r); }), 2).c_str(),
                interval_text(s.of(exponent), 2).c_str());
  }
}

int study(const Options& o) {
  o.validate();
  riprap::make_folder(o.out);
  const std::vector<CellSeries> all = make_tests(o);
  const fs::path folder = o.out;
  riprap::write_file(folder / "curve.csv", table(all));
  riprap::write_file(folder / "summary.json", summary(o, all).dump(2) + "\n");
  charts(all).save(folder / "attrition.svg");
  all[all.size() - 2].results.front().picture.save(folder / "cell.svg");
  print(all);
  std::printf("tables and pictures in %s\n", o.out.c_str());
  return command_line::finished;
}

}  // namespace

int main(int argc, char** argv) {
  Options o;
  o.assembly.count = 150;
  o.samples = 2;
  o.normal_stresses = {2e6, 4e6, 8e6};
  o.shear = 2;
  o.out = "attrition";
  CLI::App app{"Attrition in simple shear at constant normal stress: the mass that breaks off the "
               "particles\n"
               "of a periodic cell against shear strain and work; the last normal stress again, "
               "ten times as\n"
               "fast."};
  app.get_formatter()->column_width(42);
  command_line::OptionTable table(app);
  add_options(table, o, "shear strain at the end [-]");
  command_line::parse_or_exit(app, [&] { app.parse(argc, argv); });
  if (o.quick) {
    o.assembly.count = 60;
    o.samples = 1;
    o.shear = 0.1;
    o.normal_stresses = {8e6, 16e6};
  }
  return command_line::run_program(table.names(), [&] { return study(o); });
}
