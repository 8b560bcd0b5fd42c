// SPDX-License-Identifier: BSL-1.0
#include <paper/results/curve_features.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/core/errors.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using report::Run;
using riprap::test::contains;
using riprap::test::message_of;
using riprap::test::near;

namespace {

// Means of some tens of numbers of order 1.
constexpr double round_off = 1e-14;

/// y(strain) up to 20 % in steps of a quarter of a per cent.
template <class Function>
Run run_of(Function y) {
  Run run;
  for (int i = 0; i <= 80; ++i) {
    run.curve["axial_strain"].push_back(0.0025 * i);
    run.curve["y"].push_back(y(0.0025 * i));
  }
  return run;
}

}  // namespace

TEST_CASE("means over windows of a straight line are the values in their middle") {
  const Run run = run_of([](double e) { return 3 + 2 * e; });
  CHECK(report::mean_between(run, "y", 0.05, 0.10) == near(3 + 2 * 0.075, round_off));
  CHECK(report::at_end(run, "y") == near(3 + 2 * 0.175, round_off));
  CHECK(report::at_start(run, "y") == 3);
  CHECK(report::largest(run, "y") == near(3.4, round_off));
  CHECK(std::isnan(report::mean_between(run, "y", 0.21, 0.3)));
}

TEST_CASE("a spike of one record is a largest value and no peak") {
  const Run run = run_of([](double e) {
    return 1 - 100 * (e - 0.08) * (e - 0.08) + (std::abs(e - 0.15) < 1e-9 ? 1 : 0);
  });
  CHECK(report::largest(run, "y") > 1.5);
  const report::Peak peak = report::smooth_peak(run, "y");
  CHECK(peak.strain == near(0.08, 1e-12));
  // The parabola's mean over nine records, 100 * 0.0025^2 * 2 (1 + 4 + 9 + 16) / 9 below its top.
  CHECK(peak.value == near(1 - 100 * 6.25e-6 * 60 / 9, round_off));
}

TEST_CASE("a curve that rises to a plateau loses nothing and reaches nine tenths where it should") {
  const Run run = run_of([](double e) { return std::min(e / 0.1, 1.0); });
  CHECK(report::loss_after_peak(run, "y") == near(0, round_off));
  CHECK(report::strain_at_share_of_peak(run, "y", 0.895) == near(0.09, 1e-12));
}

TEST_CASE("a curve that still rises has lost nothing") {
  const Run run = run_of([](double e) { return e; });
  CHECK(report::loss_after_peak(run, "y") == 0);
}

TEST_CASE("what is lost after a peak is a share of it") {
  const Run run = run_of([](double e) { return e < 0.1 ? 2.0 : 1.5; });
  CHECK(report::loss_after_peak(run, "y") == near(0.25, round_off));
}

TEST_CASE("the gap is the mean distance, whatever its sign, and leaves out the first per cent") {
  Run run = run_of([](double) { return 0.0; });
  for (const double e : run.column("axial_strain")) {
    run.curve["sin_phi"].push_back(0.5);
    run.curve["above_and_below"].push_back(e < 0.00999 ? 99 : e < 0.10499 ? 0.6 : 0.4);
  }
  CHECK(report::mean_gap(run, "above_and_below") == near(0.1, round_off));
}

TEST_CASE("a column that is not there is named") {
  CHECK(contains(message_of([] { static_cast<void>(report::largest(Run{}, "a_n")); }),
                 "no column \"a_n\""));
}
