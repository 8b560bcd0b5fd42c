// SPDX-License-Identifier: BSL-1.0
#include <paper/claims/causes.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include <paper/results/curve_features.hpp>

#include <paper/made_up_study.hpp>

using report::Mode;
using riprap::test::made_up_study;

TEST_CASE("a run that differs in one thing stands below its series, with what it changes") {
  const report::Results results = made_up_study({});
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / "riprap_causes_test";
  std::filesystem::remove_all(folder);
  CHECK(report::causes_table(results, folder).rows.empty());

  // As the first sample at 8 MPa, but that eq. 14 predicts 0.02 more.
  report::Run run = *results.first(Mode::wb, 8e6);
  for (double& value : run.curve["sin_phi_eq_14"]) value += 0.02;
  const auto place = folder / "causes" / "wb_8MPa_1_stocky_pieces";
  std::filesystem::create_directories(place);
  std::ofstream(place / "run.json") << riprap::test::run_json(run).dump();
  const report::Table table = report::causes_table(results, folder);
  REQUIRE(table.rows.size() == 2);
  CHECK(table.rows[0][1] == "nothing: the same sample in the series");
  CHECK(table.rows[1][1].starts_with("slender pieces"));
  CHECK(table.rows[1].back() == "+0.020");      // all of it was above already
  CHECK(table.rows[0][3] == table.rows[1][3]);  // eq. 15 is as before
  // The scatter is the standard deviation of the three samples' mean distances.
  double sum = 0;
  double squares = 0;
  const auto samples = results.of(Mode::wb, 8e6);
  for (const report::Run* sample : samples) {
    const double gap = report::mean_gap(*sample, "sin_phi_eq_14");
    sum += gap;
    squares += gap * gap;
  }
  const auto n = static_cast<double>(samples.size());
  char expected[48];
  std::snprintf(expected, sizeof expected, "scatter %.3f",
                std::sqrt((squares - sum * sum / n) / (n - 1)));
  CHECK(table.rows[0].back() == expected);
  std::filesystem::remove_all(folder);
}
