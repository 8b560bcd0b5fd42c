// SPDX-License-Identifier: BSL-1.0
#include <paper/results/samples.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <support/near.hpp>

using report::Estimate;
using report::Outcome;
using report::outcome_above_zero;
using riprap::test::near;

TEST_CASE("mean and standard error of three numbers by hand") {
  const Estimate e = report::estimate({1, 2, 6});
  CHECK(e.mean == 3);
  // Squares 4 + 1 + 9 over two degrees of freedom, over three samples.
  CHECK(e.standard_error == near(std::sqrt(7.0 / 3), 1e-15));
  CHECK(e.samples == 3);
}

TEST_CASE("a single number has a mean and no error, none has neither") {
  CHECK(report::estimate({4}).mean == 4);
  CHECK(std::isnan(report::estimate({4}).standard_error));
  CHECK(std::isnan(report::estimate({}).mean));
}

TEST_CASE("a difference counts beyond the tabled quantiles of Student's distribution") {
  // One-sided 95 %, from the usual table, to its last digit.
  struct Quantile {
    std::size_t samples;
    double t;
  };
  for (const auto [samples, t] : {Quantile{2, 6.314}, {3, 2.920}, {4, 2.353}, {11, 1.812}}) {
    CAPTURE(samples);
    CHECK(outcome_above_zero({t + 0.001, 1, samples}) == Outcome::agrees);
    CHECK(outcome_above_zero({t - 0.001, 1, samples}) == Outcome::within_scatter);
    CHECK(outcome_above_zero({-t + 0.001, 1, samples}) == Outcome::within_scatter);
    CHECK(outcome_above_zero({-t - 0.001, 1, samples}) == Outcome::against);
  }
}

TEST_CASE("no difference without any scatter is no difference") {
  CHECK(outcome_above_zero(report::estimate({0, 0, 0})) == Outcome::within_scatter);
  CHECK(outcome_above_zero(report::estimate({1, 1, 1})) == Outcome::agrees);
}

TEST_CASE("correlation of four points by hand, and its error") {
  // Deviations -3 -1 1 3 and -1 -3 3 1: sum of products 12, of squares 20 and 20.
  const Estimate r = report::correlation({0, 2, 4, 6}, {2, 0, 6, 4});
  CHECK(r.mean == near(0.6, 1e-15));
  CHECK(r.standard_error == near(std::sqrt(0.64 / 2), 1e-15));
  // 0.6 / 0.566 is below 2.920, the quantile of two degrees of freedom.
  CHECK(outcome_above_zero(r) == Outcome::within_scatter);
  CHECK(report::correlation({1, 2, 3}, {5, 5, 5}).mean == 0);
}
