// SPDX-License-Identifier: BSL-1.0
#include <paper/rockfill/rockfill.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <paper/rockfill/rockfill_samples.hpp>
#include <riprap/measurement/leps_rockfill.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/svg_document.hpp>

using namespace riprap;
using rockfill::Json;
using test::message_of;
using test::near;
using test::near_relative;

namespace {

// Means of some tens of numbers.
constexpr double round_off = 1e-12;

/// What a run would leave: sin phi rises evenly up to 4 % of strain, stays there up to 12 % and
/// loses a fifth; porosity falls from 0.2 by 0.02.
Json run_of(const std::string& mode, double pressure, int seed, double peak) {
  Json strains = Json::array();
  Json minor = Json::array();
  Json major = Json::array();
  Json sin_phi = Json::array();
  Json porosity = Json::array();
  for (int i = 0; i <= 40; ++i) {
    const double strain = 0.005 * i;
    const double s = i <= 24 ? peak * std::min(strain / 0.04, 1.0) : 0.8 * peak;
    strains.push_back(strain);
    minor.push_back(pressure);
    major.push_back(pressure * (1 + s) / (1 - s));
    sin_phi.push_back(s);
    porosity.push_back(0.2 - 0.1 * strain);
  }
  const bool breaks = mode != "nb";
  return {{"mode", mode},
          {"pressure_Pa", pressure},
          {"seed", seed},
          {"curve",
           {{"axial_strain", strains},
            {"sigma_11_Pa", minor},
            {"sigma_22_Pa", major},
            {"sin_phi", sin_phi},
            {"porosity", porosity}}},
          {"grading",
           {{"size_m", {0.004, 0.010, 0.020}},
            {"finer_before", {0.0, 0.25, 1.0}},
            {"finer_after", {breaks ? 0.1 : 0.0, breaks ? 0.5 : 0.25, 1.0}},
            {"marsal_b_g", breaks ? 2e-8 * pressure : 0.0}}}};
}

/// sin phi of a test on tau/p_a = A (sigma_n/p_a)^b under sigma_3, by bisection.
double on_power_law(double a, double b, double minor) {
  double low = 0;
  double high = 1;
  for (int i = 0; i < 100; ++i) {
    const double s = 0.5 * (low + high);
    const double normal = minor * (1 + s) / atmospheric_pressure;
    const bool weaker = s / std::sqrt(1 - s * s) < a * std::pow(normal, b - 1);
    (weaker ? low : high) = s;
  }
  return low;
}

/// Three samples of both modes at the paper's pressures; one of two on a power law.
std::vector<Json> study() {
  std::vector<Json> runs;
  for (const double pressure : {14e6, 0.5e6, 1e6, 2e6, 4e6, 8e6})
    for (int seed = 1; seed <= 3; ++seed) {
      runs.push_back(run_of("wb", pressure, seed, on_power_law(1.5, 0.85, pressure)));
      runs.push_back(run_of("nb", pressure, seed, 0.6 + 0.01 * (seed - 2)));
    }
  return runs;
}

const Series& series_of(const Chart& chart, const std::string& name) {
  const auto found = std::find_if(chart.series.begin(), chart.series.end(),
                                  [&](const Series& s) { return s.name == name; });
  REQUIRE(found != chart.series.end());
  return *found;
}

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

}  // namespace

TEST_CASE("a run has its strength, stiffness, porosity and gradings") {
  const rockfill::Sample s = rockfill::read_sample(run_of("wb", 2e6, 1, 0.5));
  CHECK(degrees(s.strength.friction_angle) == near_relative(30, round_off));
  CHECK(s.strength.normal_stress == near_relative(3e6, round_off));
  CHECK(s.initial_porosity == 0.2);
  CHECK(s.final_porosity == near_relative(0.18, round_off));
  CHECK(s.marsal == 0.04);
  CHECK(s.before.passing(0.010) == 0.25);
  CHECK(s.after.passing(0.010) == 0.5);
  // The deviator rises to 4 MPa; half of it is sin phi = 1/3, between the records at 2.5 and 3 %:
  // 1.818181... and 2.4 MPa.
  const double share = (2 - 20.0 / 11) / (2.4 - 20.0 / 11);
  CHECK(s.e_50.modulus == near_relative(2e6 / (0.025 + 0.005 * share), round_off));
}

TEST_CASE("a single record is no peak") {
  Json run = run_of("nb", 2e6, 1, 0.5);
  run["curve"]["sin_phi"][16] = 0.9;
  // One of the five records within 1 % of strain.
  const rockfill::Sample s = rockfill::read_sample(run);
  CHECK(std::sin(s.strength.friction_angle) == near_relative(0.5 + 0.4 / 5, round_off));
  run["curve"]["sin_phi"][16] = nullptr;
  CHECK(std::sin(rockfill::read_sample(run).strength.friction_angle) ==
        near_relative(0.5, round_off));
}

TEST_CASE("groups are in order, with means and standard deviations of their samples") {
  const std::vector<rockfill::Group> groups = rockfill::grouped(study());
  REQUIRE(groups.size() == 12);
  CHECK(groups[0].mode == "nb");
  CHECK(groups[0].pressure == 0.5e6);
  CHECK(groups[6].mode == "wb");
  CHECK(groups[11].pressure == 14e6);
  const rockfill::Statistic s = groups[0].statistic(
      [](const rockfill::Sample& x) { return std::sin(x.strength.friction_angle); });
  CHECK(s.mean == near_relative(0.6, round_off));
  CHECK(s.deviation == near_relative(0.01, 100 * round_off));
  const std::vector<rockfill::Group> one = rockfill::grouped({run_of("nb", 2e6, 1, 0.5)});
  CHECK(one[0].statistic([](const rockfill::Sample&) { return 7.0; }).deviation == 0);
}

TEST_CASE("a mean grading lies between its curves and keeps their ends") {
  const Grading fine = Grading::of_sieves({{1e-3, 0.2}, {4e-3, 1}});
  const Grading coarse = Grading::of_sieves({{4e-3, 0}, {16e-3, 1}});
  const std::vector<GradingPoint> mean = rockfill::mean_grading({fine, coarse}, 5);
  REQUIRE(mean.size() == 5);
  const std::vector<double> sizes{1e-3, 2e-3, 4e-3, 8e-3, 16e-3};
  const std::vector<double> passing{0.1, 0.3, 0.5, 0.75, 1};
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(mean[i].size == near_relative(sizes[i], round_off));
    CHECK(mean[i].passing == near(passing[i], round_off));
  }
}

TEST_CASE("the chart of strength has points, envelopes and what is published") {
  const rockfill::Findings f = rockfill::findings(study());
  REQUIRE(f.charts.size() == 5);
  const Chart& chart = f.charts[0];
  const Series& nb = series_of(chart, "NB");
  REQUIRE(nb.points.size() == 6);
  CHECK(!nb.line);
  CHECK(nb.points[0].x() == near_relative(0.8, round_off));
  // The mean of three arc sines: their curvature moves it by 0.01 degrees.
  CHECK(nb.points[0].y() == near(degrees(std::asin(0.6)), 0.01));
  CHECK(nb.y_errors[0] == near(degrees(0.01 / 0.8), 0.001));
  // All samples of WB lie on their envelope.
  const Series& wb = series_of(chart, "WB");
  for (const Vec2& p : wb.points)
    CHECK(std::tan(p.y() * std::numbers::pi / 180) ==
          near_relative(1.5 * std::pow(p.x() * 1e6 / atmospheric_pressure, -0.15), 1e-9));
  const Series& envelope = series_of(chart, "WB, fitted");
  CHECK(std::tan(envelope.points[7].y() * std::numbers::pi / 180) ==
        near_relative(1.5 * std::pow(envelope.points[7].x() * 1e6 / atmospheric_pressure, -0.15),
                      1e-9));
  // Leps is solid up to 3.4 MPa and dashed from there.
  const Series& average = series_of(chart, "Leps, average");
  CHECK(!average.dashed);
  CHECK(average.points.back().x() == near_relative(3.4473785, 1e-9));
  CHECK(average.points.back().y() ==
        near(degrees(LepsRockfill::average().friction_angle(3.4473785e6)), 1e-9));
  const auto beyond = std::find_if(chart.series.begin(), chart.series.end(), [&](const Series& s) {
    return s.dashed && s.colour == average.colour;
  });
  REQUIRE(beyond != chart.series.end());
  CHECK(beyond->name.empty());
  CHECK(beyond->points.front().x() == near_relative(3.4473785, 1e-9));
  (void)series_of(chart, "B-K 5, 60 MPa");
  (void)series_of(chart, "B-K 10, 150 MPa");
}

TEST_CASE("breakage, gradings, porosity and stiffness stand against pressure") {
  const rockfill::Findings f = rockfill::findings(study());
  const Series& broken = series_of(f.charts[1], "WB");
  REQUIRE(broken.points.size() == 6);
  CHECK(broken.points[5].x() == near_relative(14, round_off));
  CHECK(broken.points[5].y() == near_relative(28, round_off));
  CHECK(series_of(f.charts[2], "before").points.size() == 60);
  CHECK(series_of(f.charts[2], "after, 0.5 MPa").points.back().y() ==
        near_relative(100, round_off));
  CHECK(f.charts[2].series.size() == 7);
  CHECK(series_of(f.charts[3], "NB, before").points[2].y() == near_relative(0.2, round_off));
  CHECK(series_of(f.charts[3], "NB, after").points[2].y() == near_relative(0.18, round_off));
  // Stress is in proportion to pressure here, and so is stiffness.
  const std::vector<Vec2>& stiff = series_of(f.charts[4], "NB").points;
  CHECK(stiff[5].y() == near_relative(28 * stiff[0].y(), round_off));
  const Svg sheet = chart_sheet(f.charts);
  CHECK(test::outside_canvas(test::svg_elements(sheet.document())) == "");
}

TEST_CASE("tables have a row a group, the envelopes and stars where no test went") {
  const rockfill::Findings f = rockfill::findings(study());
  REQUIRE(f.tables.size() == 3);
  for (const rockfill::Table& t : f.tables)
    for (const auto& row : t.rows) CHECK(row.size() == t.head.size());
  REQUIRE(f.tables[0].rows.size() == 12);
  // asin 0.6 is 36.9 degrees; a hundredth at a cosine of 0.8 is 0.7 degrees.
  const std::vector<std::string>& row = f.tables[0].rows[2];
  const std::vector<std::string> start(row.begin(), row.begin() + 7);
  CHECK(start == std::vector<std::string>{"NB", "2.0", "3", "36.9 ± 0.7", "0.0", "0.200", "0.180"});
  REQUIRE(f.tables[1].rows.size() == 2);
  CHECK(f.tables[1].rows[1][0] == "WB");
  CHECK(f.tables[1].rows[1][1] == "1.500");
  CHECK(f.tables[1].rows[1][2] == "0.850");
  CHECK(f.tables[1].rows[1][3] == "0.0");
  CHECK(f.tables[1].rows[0][2] == "1.000");
  // 2 MPa of confinement are 3.2 MPa on the plane, 4 MPa are 6.4: the tests ended at 3.4.
  CHECK(f.tables[2].rows[2][5] == "37.0");
  CHECK(f.tables[2].rows[3][5] == "34.9*");
}

TEST_CASE("a study that has only begun is reported as far as it goes") {
  Json run = run_of("nb", 2e6, 1, 0.5);
  run["grading"]["marsal_b_g"] = nullptr;
  const rockfill::Findings f = rockfill::findings({run});
  CHECK(f.charts.size() == 4);  // no gradings without WB
  CHECK(f.tables[0].rows[0][4] == "-");
  CHECK(f.tables[0].rows[0][3] == "30.0");
  CHECK(f.tables[1].rows.empty());
  CHECK(series_of(f.charts[1], "NB").points.empty());
  CHECK(test::svg_elements(chart_sheet(f.charts).document()).size() > 4);
}

TEST_CASE("the order of the runs does not matter") {
  std::vector<Json> runs = study();
  const std::string one = chart_sheet(rockfill::findings(runs).charts).document();
  std::stable_sort(runs.begin(), runs.end(), [](const Json& a, const Json& b) {
    return a["pressure_Pa"] < b["pressure_Pa"];
  });
  CHECK(chart_sheet(rockfill::findings(runs).charts).document() == one);
}

TEST_CASE("runs that cannot be are refused") {
  CHECK(message_of([] { (void)rockfill::findings({}); }) ==
        "number of runs = 0: must be 1 or more");
  Json run = run_of("nb", 2e6, 1, 0.5);
  run["mode"] = "x";
  CHECK(message_of([&] { (void)rockfill::findings({run}); }) ==
        "mode \"x\" of a run must be nb or wb");
  run = run_of("nb", 2e6, 1, 0.5);
  run["curve"]["porosity"].erase(3);
  CHECK(message_of([&] { (void)rockfill::findings({run}); }) ==
        "number of values of porosity = 40: must be that of its table's first column");
  run["curve"].erase("porosity");
  CHECK_THROWS_AS((void)rockfill::findings({run}), Json::exception);
}
