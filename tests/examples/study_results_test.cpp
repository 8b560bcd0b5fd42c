// SPDX-License-Identifier: BSL-1.0
#include <study/plot.hpp>
#include <study/results.hpp>
#include <study/tables.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <sstream>

#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/temporary_folder.hpp>

using namespace run_study;
using riprap::test::contains;
using riprap::test::message_of;
using riprap::test::near_relative;

namespace {

// Hours of sleep that two drugs added, for ten patients (Student, Biometrika 6, 1908, p. 20).
constexpr double drugs[2][10] = {{0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0},
                                 {1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4}};

// A study whose runs have them as their first result: two pressures for the drugs, a seed a
// patient.
struct Sleep {
  Study study = study_of(table_from_toml("t.toml", "seeds = 10\n[axes]\npressure = [1e6, 2e6]\n"));
  std::vector<FinishedRun> runs{};

  Sleep() {
    for (const Run& run : study.runs) {
      std::vector<double> results(result_columns().size(), std::nan(""));
      results[0] = drugs[run.parameters.at("pressure") == "2e+06"][run.seed - 1];
      runs.push_back({&run, results});
    }
  }
};

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> out;
  std::istringstream text(line + ",");
  for (std::string cell; std::getline(text, cell, ',');) out.push_back(cell);
  return out;
}

// The value below a name in a row of a table, rows from 1.
std::string at(const std::string& csv, int row, const std::string& name) {
  std::istringstream text(csv);
  std::string names;
  std::string line;
  std::getline(text, names);
  for (int k = 0; k < row; ++k) std::getline(text, line);
  const auto header = cells(names);
  for (std::size_t c = 0; c < header.size(); ++c)
    if (header[c] == name) return cells(line).at(c);
  return "no such column";
}

}  // namespace

TEST_CASE("a row of runs.csv has parameters, seed and results") {
  const Sleep sleep;
  const std::string csv = runs_csv(sleep.study, sleep.runs);
  CHECK(csv.starts_with("run,pressure,seed,peak_sin_phi,"));
  CHECK(at(csv, 12, "run") == "pressure=2e6_seed=2");
  CHECK(at(csv, 12, "pressure") == "2e+06");
  CHECK(at(csv, 12, "seed") == "2");
  CHECK(at(csv, 12, "peak_sin_phi") == "0.8");
  CHECK(at(csv, 12, "breakages") == "");
}

TEST_CASE("means, and differences of pairs with the interval of Student's t") {
  const Sleep sleep;
  const auto all = combinations_of(sleep.runs);
  REQUIRE(all.size() == 2);
  const Against against = against_from("pressure", sleep.study.runs);
  CHECK(against.value == "1e+06");
  const std::string csv = summary_csv(sleep.study, all, against);
  const auto number = [&](int row, const char* name) { return std::stod(at(csv, row, name)); };
  CHECK(at(csv, 1, "n") == "10");
  CHECK(number(1, "peak_sin_phi_mean") == near_relative(0.75, 1e-12));
  CHECK(number(2, "peak_sin_phi_mean") == near_relative(2.33, 1e-12));
  // sd of the two samples, as printed by R for its data set `sleep`.
  CHECK(number(1, "peak_sin_phi_sd") == near_relative(1.78901, 1e-5));
  CHECK(number(2, "peak_sin_phi_sd") == near_relative(2.002249, 1e-6));
  CHECK(number(1, "peak_sin_phi_high") ==
        near_relative(0.75 + 2.262157 * 1.78901 / std::sqrt(10.0), 1e-5));
  CHECK(at(csv, 1, "pairs") == "");
  CHECK(at(csv, 1, "peak_sin_phi_difference") == "");
  CHECK(at(csv, 2, "pairs") == "10");
  CHECK(number(2, "peak_sin_phi_difference") == near_relative(1.58, 1e-12));
  CHECK(number(2, "peak_sin_phi_difference_low") == near_relative(0.7001142, 1e-7));
  CHECK(number(2, "peak_sin_phi_difference_high") == near_relative(2.4598858, 1e-7));
  CHECK(at(csv, 2, "breakages_difference") == "");
}

TEST_CASE("seeds without their partner are no pair") {
  Sleep sleep;
  sleep.runs.erase(sleep.runs.begin() + 3);
  const auto all = combinations_of(sleep.runs);
  CHECK(paired_differences(all[1], all[0], 0).size() == 9);
}

TEST_CASE("what a combination is compared with") {
  const Study study = study_of(table_from_toml(
      "t.toml", "[[rows]]\nname = \"base\"\npressure = [1e6, 2e6]\n"
                "[[rows]]\nname = \"soft\"\nyoung = 1e9\npressure = [1e6, 4e6]\n"
                "[[rows]]\nname = \"rough\"\nfriction = [0.6, 0.8]\npressure = [2e6]\n"));
  std::vector<FinishedRun> runs;
  for (const Run& run : study.runs)
    runs.push_back({&run, std::vector<double>(result_columns().size())});
  const auto all = combinations_of(runs);
  const auto reference = [&](std::size_t k, const Against& against) -> std::string {
    const Combination* found = reference_of(all[k], against, all);
    return found ? found->first().folder : "";
  };
  const Against base = against_from("row=base", study.runs);
  CHECK(reference(0, base) == "");
  CHECK(reference(2, base) == "base_pressure=1e6_seed=1");
  CHECK(reference(3, base) == "");  // which the base has not
  CHECK(reference(4, base) == "base_pressure=2e6_seed=1");
  const Against friction = against_from("friction=0.60", study.runs);
  CHECK(reference(5, friction) == "rough_friction=0.6_pressure=2e6_seed=1");
  CHECK(reference(4, friction) == "");
  CHECK(reference(0, friction) == "");
  const auto refusal = [&](const char* text) {
    return message_of([&] { (void)against_from(text, study.runs); });
  };
  CHECK(refusal("young=1e9") ==
        "--against: 'young' is not what runs of the table differ in: friction, pressure, row");
  CHECK(refusal("friction=7") == "--against: no run has friction=7");
}

TEST_CASE("a table in Markdown has the options that vary") {
  const Sleep sleep;
  const std::string text = table_md(sleep.study, combinations_of(sleep.runs));
  CHECK(text.starts_with("| pressure | samples |"));
  CHECK(contains(text, "\n| 2e+06 | 10 |"));
}

TEST_CASE("points of all runs, means with their intervals") {
  const Sleep sleep;
  const auto all = combinations_of(sleep.runs);
  const riprap::Chart chart = chart_of(plot_from("peak_sin_phi:pressure", {}), sleep.study, all);
  REQUIRE(chart.series.size() == 2);
  CHECK(chart.series[0].points.size() == 20);
  CHECK(!chart.series[0].line);
  CHECK(chart.series[1].points[1].x() == 2);
  CHECK(chart.x_label == "pressure / 1e6");
  CHECK(chart.series[1].points[1].y() == near_relative(2.33, 1e-12));
  CHECK(chart.series[1].y_errors[1] == near_relative(2.262157 * 2.002249 / std::sqrt(10.0), 1e-6));
  CHECK(chart.series[1].line);
  const riprap::Chart over_result =
      chart_of(plot_from("peak_sin_phi:peak_sin_phi:pressure", {}), sleep.study, all);
  REQUIRE(over_result.series.size() == 4);
  CHECK(over_result.series[2].name == "pressure 1e+06");
  CHECK(!over_result.series[2].line);
  CHECK(chart.x_scale == riprap::AxisScale::linear);
  Plot logarithmic = plot_from("peak_sin_phi:pressure", {});
  logarithmic.log_x = true;
  const riprap::Chart over_log = chart_of(logarithmic, sleep.study, all);
  CHECK(over_log.x_scale == riprap::AxisScale::logarithmic);
  CHECK(over_log.series[1].points[1] == chart.series[1].points[1]);
  const Plot grouped = plot_from("peak_sin_phi:seed:pressure", {"pressure=1e6"});
  CHECK(file_name(grouped) == "peak_sin_phi_seed_pressure_pressure=1e6.svg");
}

TEST_CASE("plots that cannot be drawn are refused") {
  const Sleep sleep;
  const auto refusal = [&](const char* text, const std::vector<std::string>& where = {}) {
    return message_of(
        [&] { (void)chart_of(plot_from(text, where), sleep.study, combinations_of(sleep.runs)); });
  };
  CHECK(refusal("a") == "--plot: 'a' is not Y:X or Y:X:GROUP");
  CHECK(contains(refusal("a:pressure"), "'a' is not a result"));
  CHECK(contains(refusal("breakages:a"), "'a' is neither an option of the table nor a result"));
  CHECK(contains(refusal("breakages:row"), "row = '' must be a number"));
  CHECK(contains(refusal("breakages:pressure", {"pressure"}), "is not OPTION=VALUE"));
  CHECK(contains(refusal("breakages:pressure", {"pressure=3"}), "no finished run to show"));
  Plot over_results = plot_from("peak_sin_phi:peak_sin_phi", {});
  over_results.log_x = true;
  CHECK(message_of([&] {
          (void)chart_of(over_results, sleep.study, combinations_of(sleep.runs));
        }).find("= -1.6: must be above 0 on a logarithmic axis") != std::string::npos);
  const Study two =
      study_of(table_from_toml("t.toml", "[axes]\npressure = [1e6]\nfriction = [0.1, 0.2]\n"));
  std::vector<FinishedRun> runs;
  for (const Run& run : two.runs)
    runs.push_back({&run, std::vector<double>(result_columns().size())});
  CHECK(contains(message_of([&] {
                   (void)chart_of(plot_from("breakages:pressure", {}), two, combinations_of(runs));
                 }),
                 "have the same pressure, which differ in friction"));
}

TEST_CASE("the results of a run are in its summary, its curve and its energies") {
  const riprap::test::TemporaryFolder folder;
  folder.write("summary.json",
               R"({"peak": {"sin_phi": 0.6, "axial_strain": 0.05}, "end": null,
 "counts": {"breakages": 7}, "grading_before_and_after": {"hardin_b_r": null},
 "stages": [{"steps": 10, "wall_s": 1}, {"steps": 30, "wall_s": 2}],
 "checks": [{"holds": true}, {"holds": false}]})");
  folder.write("curve.csv", "axial_strain,sin_phi,overlap_ratio\n0,0.1,0\n0.005,0.7,0\n"
                            "0.1,0.5,0\n0.19,0.2,0\n0.2,0.4,0.01\n");
  folder.write("energy.csv",
               "axial_strain,boundary_work,damping,breakage,law_residual\n0.2,4,2,1,-0.5\n");
  const std::vector<double> values = results_in(folder.path());
  const auto value = [&](const std::string& name) {
    for (std::size_t k = 0; k < values.size(); ++k)
      if (result_columns()[k].name == name) return values[k];
    return -1.0;
  };
  REQUIRE(values.size() == result_columns().size());
  CHECK(value("peak_sin_phi") == 0.6);
  CHECK(value("strain_at_peak") == 0.05);
  CHECK(std::isnan(value("end_sin_phi")));
  CHECK(value("breakages") == 7);
  CHECK(std::isnan(value("hardin_b_r")));
  CHECK(value("smoothed_peak_sin_phi") == 0.5);  // 0.1 and 0.7 are one mean, 0.5 is alone
  CHECK(value("residual_sin_phi") == near_relative(0.3, 1e-12));
  CHECK(value("law_share") == -0.125);
  CHECK(value("splitting_share") == 0.25);
  CHECK(value("damping_share") == 0.5);
  CHECK(value("end_overlap_ratio") == 0.01);
  CHECK(value("checks_broken") == 1);
  CHECK(value("steps") == 40);
  CHECK(value("wall_s") == 3);
  CHECK(value("step_wall_s") == near_relative(0.075, 1e-12));
  folder.write("summary.json", "{");
  CHECK_THROWS_WITH_AS((void)results_in(folder.path()),
                       ((folder / "summary.json").string() + " cannot be read").c_str(),
                       riprap::SimulationError);
}
