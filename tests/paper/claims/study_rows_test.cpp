// SPDX-License-Identifier: BSL-1.0
#include <paper/claims/study_rows.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <support/message_of.hpp>

#include <paper/made_up_study.hpp>

using report::Mode;
using report::Results;
using report::Table;
using riprap::test::contains;
using riprap::test::made_up_study;

namespace {

/// The runs of a series again, with more sin phi: a number for all, and a little for each sample.
void add_row(Results& results, const std::string& variation, Mode mode, double pressure,
             double more) {
  for (const report::Run* run : results.of(mode, pressure)) {
    report::Run row = *run;
    row.variation = variation;
    for (double& value : row.curve["sin_phi"]) value += more + 1e-3 * (run->seed - 2);
    results.rows.push_back(row);
  }
}

}  // namespace

TEST_CASE("a row stands below its series, and what it changes is told sample by sample") {
  Results results = made_up_study({});
  CHECK(rows_table(results).rows.empty());
  CHECK(row_changes_table(results).rows.empty());
  add_row(results, "failure_plane", Mode::wb, 14e6, -0.05);
  add_row(results, "slow_shear", Mode::wb, 14e6, 0);
  const Table means = rows_table(results);
  REQUIRE(means.rows.size() == 3);
  CHECK(means.rows[0][1] == "nothing");
  CHECK(means.rows[1][1].starts_with("crack along the failure plane"));
  CHECK(means.rows[2][1] == "half the rate of strain");
  const Table changes = row_changes_table(results);
  REQUIRE(changes.rows.size() == 2);
  CHECK(changes.head[2] == "peak sin phi");
  // Standard error of -1, 0, 1 thousandths: 1e-3 / sqrt(3).
  CHECK(changes.rows[0][2] == "**-0.050 ± 0.001**");
  CHECK(changes.rows[1][2] == "+0.000 ± 0.001");
}

TEST_CASE("the share of contact softness in the fall of strength is that of the slopes") {
  Results results = made_up_study({});
  CHECK(softness_text(results).empty());
  for (const double pressure : {0.5e6, 2e6, 14e6})
    add_row(results, "stiff_contacts", Mode::nb, pressure, 0);
  const std::string text = softness_text(results);
  CHECK(contains(text, "over 0.5 MPa, 2 MPa and 14 MPa the largest sin phi changes"));
  // Breakage lowers it everywhere alike: all of the fall is there without it.
  CHECK(contains(text, "which is 100 % of it"));
}
