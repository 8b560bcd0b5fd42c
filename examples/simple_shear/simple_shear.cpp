// SPDX-License-Identifier: BSL-1.0
// simple_shear: a periodic cell in simple shear: strength, volume, principal axes, velocity profile

#include <CLI/CLI.hpp>
#include <algorithm>
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

struct ShearOptions : Options {
  std::string control = "stress";
};

constexpr double end_share = 0.25;  // of the test, over which its end is averaged

constexpr auto strain = [](const CellRecord& r) { return r.strain; };
constexpr auto ratio = [](const CellRecord& r) { return r.ratio(); };
constexpr auto rise = [](const CellRecord& r) { return 100 * r.rise; };
constexpr auto direction = [](const CellRecord& r) { return major_direction(r.stress); };
constexpr auto mean_stress = [](const CellRecord& r) { return 1e-6 * r.stress.mean(); };
constexpr auto breakages = [](const CellRecord& r) { return static_cast<double>(r.breakages); };
constexpr auto sin_phi = [](const CellRecord& r) { return r.stress.radius() / r.stress.mean(); };

// Of the mean over five records.
template <class Value>
double largest(const CellResult& r, Value&& value) {
  constexpr std::size_t window = 5;
  double most = 0;
  for (std::size_t i = 0; i + window <= r.records.size(); ++i) {
    double mean = 0;
    for (std::size_t k = i; k < i + window; ++k) mean += value(r.records[k]) / window;
    most = std::max(most, mean);
  }
  return most;
}
double lag(const CellResult& r) {
  return mean_at_end(r, end_share, direction) -
         mean_at_end(r, end_share, [](const CellRecord& rec) {
           return major_direction_of_rate(rec.contraction);
         });
}
// The stress that follows from the work of the boundary.
double work_error(const CellResult& r) {
  return r.records.back().stress_work / r.records.back().work - 1;
}

std::vector<CellSeries> make_tests(const ShearOptions& o) {
  std::vector<CellPlan> plans;
  for (const double stress : o.normal_stresses)
    plans.push_back({stress_text(stress),
                     {.normal_stress = stress,
                      .inertial_number = o.inertial_number,
                      .constant_volume = o.control == "volume",
                      .seed = o.assembly.seed}});
  return run_cells(o, plans);
}

Json series_json(const CellSeries& s) {
  Json breaks = Json::array();
  for (const CellResult& r : s.results) breaks.push_back(r.records.back().breakages);
  const auto at_end = [&](const auto& value) {
    return to_json(s.of([&](const CellResult& r) { return mean_at_end(r, end_share, value); }));
  };
  return {{"normal_stress_Pa", s.results.front().test.normal_stress},
          {"shear_rate_1_s", s.results.front().rate},
          {"shear_over_normal_peak",
           to_json(s.of([](const CellResult& r) { return largest(r, ratio); }))},
          {"shear_over_normal_end", at_end(ratio)},
          {"sin_phi_peak", to_json(s.of([](const CellResult& r) { return largest(r, sin_phi); }))},
          {"sin_phi_end", at_end(sin_phi)},
          {"rise_end_percent", at_end(rise)},
          {"major_direction_end_degrees", at_end(direction)},
          {"major_direction_of_stress_less_rate_degrees", to_json(s.of(lag))},
          {"velocity_profile_slope",
           to_json(s.of([](const CellResult& r) { return straight_line(r.profile).line.slope; }))},
          {"velocity_profile_r_squared",
           to_json(s.of([](const CellResult& r) { return straight_line(r.profile).r_squared; }))},
          {"asymmetry", to_json(s.of([](const CellResult& r) {
             return mean_at_end(r, 1,
                                [](const CellRecord& rec) { return std::abs(rec.asymmetry); });
           }))},
          {"work_of_stress_over_work_less_1", to_json(s.of(work_error))},
          {"breakages", breaks}};
}

Json summary(const ShearOptions& o, const std::vector<CellSeries>& all) {
  Json j = options_json(o);
  j["inertial_number"] = o.inertial_number;
  j["control"] = o.control;
  for (const CellSeries& s : all) j["tests"].push_back(series_json(s));
  return j;
}

riprap::Svg charts(const std::vector<CellSeries>& all, bool constant_volume) {
  const std::string x = "shear strain [-]";
  std::vector<riprap::Chart> sheet{
      {"Shear over normal stress", x, "on the plane of shear [-]", {}},
      {"Direction of the major stress", x, "from axis 1 [degrees]", {}},
      constant_volume ? riprap::Chart{"Mean stress", x, "[MPa]", {}}
                      : riprap::Chart{"Dilation", x, "rise of the cell over its height [%]", {}},
      {"Breakages in shear", x, "in a sample [-]", {}},
      {"Velocity profile",
       "velocity along axis 1 over rate times height [-]",
       "height over that of the cell [-]",
       {}},
      {"Normal stress along axis 1", x, "over that along axis 2 [-]", {}}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    const CellSeries& s = all[k];
    const auto add = [&](std::size_t chart, std::vector<Vec2> points) {
      sheet[chart].series.push_back({s.name, std::move(points), colour(k)});
    };
    add(0, s.curve(strain, ratio));
    add(1, s.curve(strain, direction));
    add(2, constant_volume ? s.curve(strain, mean_stress) : s.curve(strain, rise));
    add(3, s.curve(strain, breakages));
    add(5, s.curve(strain, [](const CellRecord& r) { return r.stress.s11 / r.stress.s22; }));
    std::vector<std::vector<Vec2>> profiles;
    for (const CellResult& r : s.results) profiles.push_back(r.profile);
    add(4, mean_curve(profiles));
    riprap::Series& marks = sheet[4].series.back();
    for (Vec2& p : marks.points) p = {p.y(), p.x()};
    marks.mark = riprap::Mark::circle;
    marks.line = false;
  }
  const double end = all.front().results.front().records.back().strain;
  sheet[1].series.push_back({"135: of the rate", {{0, 135}, {end, 135}}, "#777", true});
  sheet[4].series.push_back({"uniform shear", {{-0.5, -0.5}, {0.5, 0.5}}, "#777", true});
  return riprap::chart_sheet(sheet);
}

void print(const std::vector<CellSeries>& all) {
  std::printf("normal stress  tau/sigma at peak  at the end       direction [deg]  R^2 of profile  "
              "breakages\n");
  for (const CellSeries& s : all)
    std::printf(
        "%-13s  %-17s  %-15s  %-15s  %-14s  %s\n", s.name.c_str(),
        interval_text(s.of([](const auto& r) { return largest(r, ratio); }), 3).c_str(),
        interval_text(s.of([](const auto& r) { return mean_at_end(r, end_share, ratio); }), 3)
            .c_str(),
        interval_text(s.of([](const auto& r) { return mean_at_end(r, end_share, direction); }), 1)
            .c_str(),
        interval_text(s.of([](const auto& r) { return straight_line(r.profile).r_squared; }), 4)
            .c_str(),
        interval_text(s.of([](const auto& r) { return breakages(r.records.back()); }), 1).c_str());
  for (const CellSeries& s : all)
    std::printf("%s: sigma_12 and sigma_21 differ by %s of them, work of the mean stresses over "
                "that of the "
                "cell %s\n",
                s.name.c_str(),
                interval_text(s.of([](const auto& r) {
                  return mean_at_end(r, 1,
                                     [](const CellRecord& rec) { return std::abs(rec.asymmetry); });
                }),
                              5)
                    .c_str(),
                interval_text(s.of([](const auto& r) { return 1 + work_error(r); }), 4).c_str());
}

int study(const ShearOptions& o) {
  o.validate();
  riprap::make_folder(o.out);
  const std::vector<CellSeries> all = make_tests(o);
  const fs::path folder = o.out;
  riprap::write_file(folder / "curve.csv", table(all));
  riprap::write_file(folder / "summary.json", summary(o, all).dump(2) + "\n");
  charts(all, o.control == "volume").save(folder / "simple_shear.svg");
  for (const CellSeries& s : all) {
    const CellResult& first = s.results.front();
    first.picture.save(folder /
                       ("cell_" + riprap::to_text(1e-6 * first.test.normal_stress) + "MPa.svg"));
  }
  print(all);
  std::printf("tables and pictures in %s\n", o.out.c_str());
  return command_line::finished;
}

}  // namespace

int main(int argc, char** argv) {
  ShearOptions o;
  o.assembly.count = 300;
  o.normal_stresses = {1e6, 4e6, 8e6};
  o.shear = 0.4;
  o.out = "simple_shear";
  CLI::App app{
      "Simple shear of a periodic cell at constant normal stress or at constant volume: strength,\n"
      "dilation, direction of the principal stresses, breakages and the velocity profile."};
  app.get_formatter()->column_width(42);
  command_line::OptionTable table(app);
  add_options(table, o, "shear strain at the end [-]");
  table.add_choice("--control", o.control, {"stress", "volume"}, "what is held on axis 2");
  command_line::parse_or_exit(app, [&] { app.parse(argc, argv); });
  if (o.quick) {
    o.assembly.count = 60;
    o.samples = 1;
    o.shear = 0.05;
    o.normal_stresses = {4e6, 8e6};
  }
  return command_line::run_program(table.names(), [&] { return study(o); });
}
