// SPDX-License-Identifier: BSL-1.0
// direct_shear: a shear box: strength, dilation and breakages at several normal stresses, envelope

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <riprap/output/csv.hpp>
#include <riprap/output/file.hpp>

#include "../command_line/program.hpp"
#include "../run_table/progress_line.hpp"
#include "../shear_tests/results.hpp"
#include "features.hpp"

namespace {

using namespace direct_shear;
using riprap::Vec2;
using shear_tests::interval_text;
using shear_tests::Json;
using shear_tests::to_json;
namespace fs = std::filesystem;

// The tests at one normal stress, one for each sample.
struct Series {
  double normal_stress = 0;
  std::vector<BoxResult> results{};
  std::vector<Features> found{};

  template <class Value>
  [[nodiscard]] run_study::Statistics of(Value&& value) const {
    std::vector<double> values;
    for (const Features& f : found) values.push_back(value(f));
    return run_study::statistics_of(values);
  }
  // The mean over the samples of a value against the displacement over the width [%].
  template <class Value>
  [[nodiscard]] std::vector<Vec2> curve(Value&& value) const {
    std::vector<std::vector<Vec2>> curves;
    for (const BoxResult& r : results) {
      auto& points = curves.emplace_back();
      for (const Record& rec : r.records)
        points.push_back({100 * rec.displacement / r.size.width, value(r, rec)});
    }
    return shear_tests::mean_curve(curves);
  }
};

std::vector<Series> make_tests(const Options& o) {
  double work = 0;
  for (const double s : o.normal_stresses) work += o.samples / std::sqrt(s);
  run_table::ProgressLine line(work);
  std::vector<Series> all;
  for (const double stress : o.normal_stresses) {
    Series& series = all.emplace_back(Series{.normal_stress = stress});
    for (unsigned k = 0; k < o.samples; ++k) {
      const std::uint64_t seed = o.assembly.seed + k;
      line.begin(shear_tests::stress_text(stress) + ", seed " + std::to_string(seed),
                 1 / std::sqrt(stress));
      series.results.push_back(box_test(o, stress, seed, [&](double share) { line.at(share); }));
      series.found.push_back(features(series.results.back()));
    }
  }
  line.end();
  return all;
}

// The envelope of each sample, at the peaks or at the ends.
template <class Of>
std::vector<shear_tests::Envelope> envelopes(const std::vector<Series>& all, Of&& of) {
  std::vector<shear_tests::Envelope> lines;
  for (std::size_t k = 0; k < all.front().found.size(); ++k) {
    std::vector<Vec2> points;
    for (const Series& s : all) points.push_back({of(s.found[k]).normal, of(s.found[k]).shear});
    lines.push_back(shear_tests::envelope(points));
  }
  return lines;
}
template <class Value>
run_study::Statistics over(const std::vector<shear_tests::Envelope>& lines, Value&& value) {
  std::vector<double> values;
  for (const auto& e : lines) values.push_back(value(e));
  return run_study::statistics_of(values);
}

constexpr auto at_peak = [](const Features& f) { return f.peak; };
constexpr auto at_end = [](const Features& f) { return f.end; };

std::string table(const std::vector<Series>& all) {
  const riprap::CsvColumns<std::pair<const BoxResult*, const Record*>> columns{
      {"normal_stress", [](const auto& r) { return riprap::to_text(r.second->normal_stress); }},
      {"seed", [](const auto& r) { return std::to_string(r.second->seed); }},
      {"displacement", [](const auto& r) { return riprap::to_text(r.second->displacement); }},
      {"lift", [](const auto& r) { return riprap::to_text(r.second->lift); }},
      {"shear_lower", [](const auto& r) { return riprap::to_text(r.second->forces.shear_lower); }},
      {"shear_upper", [](const auto& r) { return riprap::to_text(r.second->forces.shear_upper); }},
      {"normal_lid", [](const auto& r) { return riprap::to_text(r.second->forces.normal_lid); }},
      {"normal_plane",
       [](const auto& r) { return riprap::to_text(r.second->forces.normal_plane); }},
      {"area", [](const auto& r) { return riprap::to_text(r.first->area()); }},
      {"breakages", [](const auto& r) { return std::to_string(r.second->breakages); }},
      {"particles", [](const auto& r) { return std::to_string(r.second->particles); }}};
  std::vector<std::pair<const BoxResult*, const Record*>> rows;
  for (const Series& s : all)
    for (const BoxResult& r : s.results)
      for (const Record& rec : r.records) rows.emplace_back(&r, &rec);
  return riprap::csv_text(columns, rows);
}

Json envelope_json(const std::vector<shear_tests::Envelope>& lines) {
  return {
      {"angle_degrees", to_json(over(lines, [](const auto& e) { return e.angle; }))},
      {"cohesion_Pa", to_json(over(lines, [](const auto& e) { return e.cohesion; }))},
      {"secant_angle_degrees", to_json(over(lines, [](const auto& e) { return e.secant_angle; }))}};
}

Json strength_json(const Series& s, const auto& of) {
  return {{"shear_over_normal", to_json(s.of([&](const Features& f) { return of(f).ratio(); }))},
          {"shear_stress_Pa", to_json(s.of([&](const Features& f) { return of(f).shear; }))},
          {"normal_stress_on_plane_Pa",
           to_json(s.of([&](const Features& f) { return of(f).normal; }))}};
}

Json summary(const Options& o, const std::vector<Series>& all) {
  Json tests = Json::array();
  for (const Series& s : all) {
    Json breakages = Json::array();
    Json before = Json::array();
    Json lost = Json::array();
    for (const BoxResult& r : s.results) {
      breakages.push_back(r.records.back().breakages);
      before.push_back(r.breakages_before_shear);
      lost.push_back(r.lost);
    }
    tests.push_back(
        {{"normal_stress_Pa", s.normal_stress},
         {"peak", strength_json(s, at_peak)},
         {"end", strength_json(s, at_end)},
         {"dilation_at_peak", to_json(s.of([](const auto& f) { return f.dilation; }))},
         {"shear_forces_difference", to_json(s.of([](const auto& f) { return f.imbalance; }))},
         {"shear_forces_difference_of_means",
          to_json(s.of([](const auto& f) { return f.mean_offset; }))},
         {"normal_plane_over_lid", to_json(s.of([](const auto& f) { return f.plane_over_lid; }))},
         {"solid_fraction_at_start", s.results.front().solid_fraction},
         {"breakages", breakages},
         {"breakages_before_shear", before},
         {"particles_lost", lost}});
  }
  return {{"particles", o.assembly.count},
          {"first_seed", o.assembly.seed},
          {"samples", o.samples},
          {"friction", o.contact.friction},
          {"compressive_strength_Pa", o.criterion.compressive_strength},
          {"damping", o.damping.coefficient},
          {"sides", o.sides},
          {"breakage", o.breakage},
          {"shear_over_width", o.shear},
          {"inertial_number", o.inertial_number},
          {"box_width_m", all.front().results.front().size.width},
          {"envelope_at_peak", envelope_json(envelopes(all, at_peak))},
          {"envelope_at_end", envelope_json(envelopes(all, at_end))},
          {"tests", tests}};
}

riprap::Chart envelope_chart(const std::vector<Series>& all) {
  riprap::Chart chart{
      "Strength of all tests", "normal stress on the plane [MPa]", "shear stress [MPa]", {}};
  const auto add = [&](const char* name, std::size_t k, riprap::Mark mark, const auto& of) {
    riprap::Series marks{name, {}, shear_tests::colour(k), false, mark, false};
    double largest = 0;
    for (const Series& s : all)
      for (const Features& f : s.found) {
        marks.points.push_back({1e-6 * of(f).normal, 1e-6 * of(f).shear});
        largest = std::max(largest, 1e-6 * of(f).normal);
      }
    const double slope =
        std::tan(shear_tests::envelope(marks.points).secant_angle * std::acos(-1.0) / 180);
    chart.series.push_back(marks);
    chart.series.push_back(
        {"", {{0, 0}, {largest, slope * largest}}, shear_tests::colour(k), true});
  };
  add("peak", 2, riprap::Mark::circle, at_peak);
  add("end", 0, riprap::Mark::square, at_end);
  return chart;
}

riprap::Chart profile_chart(const std::vector<Series>& all) {
  riprap::Chart chart{"Where the sample shears",
                      "way along axis 1 over that of the lower half [-]",
                      "height at the start over that of the sample [-]",
                      {}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    std::vector<Vec2> points;
    for (const BoxResult& r : all[k].results)
      points.insert(points.end(), r.profile.begin(), r.profile.end());
    auto means = shear_tests::bin_means(points, 0, 1, 14);
    for (Vec2& p : means) p = {p.y(), p.x()};
    chart.series.push_back({shear_tests::stress_text(all[k].normal_stress), means,
                            shear_tests::colour(k), false, riprap::Mark::circle});
  }
  return chart;
}

riprap::Svg charts(const std::vector<Series>& all) {
  const std::string x = "displacement over width [%]";
  riprap::Chart ratio{"Shear over normal stress", x, "on the parting plane [-]", {}};
  riprap::Chart lift{"Dilation", x, "rise of the lid over the height [%]", {}};
  riprap::Chart breakages{"Breakages in shear", x, "in a sample [-]", {}};
  riprap::Chart plane{"Friction of the sides", x, "normal force: plane over lid [-]", {}};
  for (std::size_t k = 0; k < all.size(); ++k) {
    const auto add = [&](riprap::Chart& chart, const auto& value) {
      chart.series.push_back({shear_tests::stress_text(all[k].normal_stress), all[k].curve(value),
                              shear_tests::colour(k)});
    };
    add(ratio, [](const BoxResult&, const Record& r) {
      return r.forces.shear_lower / r.forces.normal_plane;
    });
    add(lift, [](const BoxResult& b, const Record& r) { return 100 * r.lift / b.height; });
    add(breakages,
        [](const BoxResult&, const Record& r) { return static_cast<double>(r.breakages); });
    add(plane, [](const BoxResult&, const Record& r) {
      return r.forces.normal_plane / r.forces.normal_lid;
    });
  }
  return riprap::chart_sheet(
      {ratio, lift, envelope_chart(all), breakages, profile_chart(all), plane});
}

void print(const std::vector<Series>& all) {
  std::printf(
      "normal stress  tau/sigma at peak  at the end         dilation           breakages\n");
  for (const Series& s : all) {
    double breakages = 0;
    for (const BoxResult& r : s.results)
      breakages +=
          static_cast<double>(r.records.back().breakages) / static_cast<double>(s.results.size());
    std::printf(
        "%-13s  %-17s  %-17s  %-17s  %.1f\n", shear_tests::stress_text(s.normal_stress).c_str(),
        interval_text(s.of([](const Features& f) { return f.peak.ratio(); }), 3).c_str(),
        interval_text(s.of([](const Features& f) { return f.end.ratio(); }), 3).c_str(),
        interval_text(s.of([](const Features& f) { return f.dilation; }), 3).c_str(), breakages);
  }
  const auto line = [&](const char* name, const auto& of) {
    const auto lines = envelopes(all, of);
    std::printf(
        "%s: line through the origin at %s degrees\n", name,
        interval_text(over(lines, [](const auto& e) { return e.secant_angle; }), 1).c_str());
  };
  line("peak", at_peak);
  line("end", at_end);
  for (const Series& s : all)
    std::printf("%s: shear forces of the halves differ by %s of their mean, their means by %s; "
                "normal force "
                "on the plane %s of that on the lid\n",
                shear_tests::stress_text(s.normal_stress).c_str(),
                interval_text(s.of([](const Features& f) { return f.imbalance; }), 4).c_str(),
                interval_text(s.of([](const Features& f) { return f.mean_offset; }), 5).c_str(),
                interval_text(s.of([](const Features& f) { return f.plane_over_lid; }), 3).c_str());
}

int study(const Options& o) {
  o.validate();
  riprap::make_folder(o.out);
  const std::vector<Series> all = make_tests(o);
  const fs::path folder = o.out;
  riprap::write_file(folder / "curve.csv", table(all));
  riprap::write_file(folder / "summary.json", summary(o, all).dump(2) + "\n");
  charts(all).save(folder / "direct_shear.svg");
  for (const Series& s : all)
    s.results.front().picture.save(folder /
                                   ("box_" + riprap::to_text(1e-6 * s.normal_stress) + "MPa.svg"));
  print(all);
  std::printf("tables and pictures in %s\n", o.out.c_str());
  return command_line::finished;
}

}  // namespace

int main(int argc, char** argv) {
  Options o;
  o.assembly.count = 400;
  o.normal_stresses = {1e6, 4e6, 8e6};
  o.shear = 0.12;
  o.damping.coefficient = 0;
  o.out = "direct_shear";
  CLI::App app{
      "Direct shear tests in a box of two halves with rough walls: shear over normal stress, "
      "dilation\n"
      "and breakages against the displacement of the lower half, strength against normal stress."};
  app.get_formatter()->column_width(42);
  command_line::OptionTable table(app);
  shear_tests::add_options(table, o, "way of the lower half over the width [-]");
  table.add_choice("--sides", o.sides, {"smooth", "rough"}, "of the box; its plates are rough");
  command_line::parse_or_exit(app, [&] { app.parse(argc, argv); });
  if (o.quick) {
    o.assembly.count = 60;
    o.samples = 1;
    o.shear = 0.02;
    o.normal_stresses = {4e6, 8e6};
  }
  return command_line::run_program(table.names(), [&] { return study(o); });
}
