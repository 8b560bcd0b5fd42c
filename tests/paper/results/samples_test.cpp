// SPDX-License-Identifier: BSL-1.0
#include <paper/results/samples.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <support/near.hpp>

using report::Cell;
using report::Estimate;
using report::Outcome;
using report::outcome_above_zero;
using report::p_value;
using report::pooled;
using report::Shown;
using report::shown_by;
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

TEST_CASE("correlation of four points by hand") {
  // Deviations -3 -1 1 3 and -1 -3 3 1: sum of products 12, of squares 20 and 20.
  CHECK(report::correlation({0, 2, 4, 6}, {2, 0, 6, 4}) == near(0.6, 1e-15));
  CHECK(report::correlation({1, 2, 3}, {5, 5, 5}) == 0);
}

TEST_CASE("a pooled mean takes the samples that all cells have, one number each") {
  const std::vector<Cell> cells{{{1, 1.0}, {2, 3.0}, {3, 100.0}}, {{1, 2.0}, {2, 8.0}, {4, -7.0}}};
  const Estimate e = pooled(cells, report::mean_weights(2));
  // Samples 1 and 2: 1.5 and 5.5.
  CHECK(e.samples == 2);
  CHECK(e.mean == near(3.5, 1e-15));
  CHECK(e.standard_error == near(2, 1e-15));
  CHECK(pooled({{{1, 1.0}}, {{2, 1.0}}}, {1, 1}).samples == 0);
  CHECK(pooled({{{1, 1.0}, {2, std::nan("")}}}, {1}).samples == 1);
}

TEST_CASE("what all cells of a sample have in common does not hide a pooled contrast") {
  // Levels that differ by 10 between samples, and a step of 1, 2 or 3.
  const std::vector<Cell> cells{{{1, 10.0}, {2, 20.0}, {3, 30.0}},
                                {{1, 11.0}, {2, 22.0}, {3, 33.0}}};
  const Estimate step = pooled(cells, {-1, 1});
  CHECK(step.mean == near(2, 1e-14));
  CHECK(step.standard_error == near(1 / std::sqrt(3.0), 1e-14));
}

TEST_CASE("the weights of a slope are those of least squares") {
  // Of 1, 2, 6 over 0, 1, 3: deviations -4/3, -1/3, 5/3, of squares 42/9; products 8.
  const std::vector<double> w = report::slope_weights({0, 1, 3});
  CHECK(w[0] * 1 + w[1] * 2 + w[2] * 6 == near(8 / (42.0 / 9), 1e-14));
  CHECK(w[0] + w[1] + w[2] == near(0, 1e-15));
}

TEST_CASE("a pooled test tells an effect, a small one, none, the opposite, and not knowing apart") {
  // Eight samples: t(7; 0.95) = 1.895 of the usual table.
  const auto shown = [](double mean, double margin) { return shown_by({mean, 1, 8}, margin); };
  CHECK(shown(1.90, 0) == Shown::effect);
  CHECK(shown(1.89, 0) == Shown::neither);
  CHECK(shown(-1.89, 0) == Shown::neither);
  CHECK(shown(-1.90, 0) == Shown::opposite);
  // The upper end of the interval is at the mean + 1.895.
  CHECK(shown(1.90, 3.79) == Shown::effect);
  CHECK(shown(1.90, 3.80) == Shown::small_effect);
  CHECK(shown(1.00, 2.89) == Shown::neither);
  CHECK(shown(1.00, 2.90) == Shown::no_effect);
  CHECK(shown(-1.90, 2.90) == Shown::opposite);
}

TEST_CASE("p is one half without an effect, and 5 % at the tabled quantile") {
  CHECK(p_value({0, 1, 8}) == near(0.5, 1e-12));
  // The quantile to four digits: the density there is 0.07 (1 + t^2 / 7)^-4 / B, some 0.08.
  CHECK(p_value({1.895, 1, 8}) == near(0.05, 1e-4));
  CHECK(p_value({-1.895, 1, 8}) == near(0.95, 1e-4));
  CHECK(p_value({1, 0, 8}) == 0);
  CHECK(p_value({-1, 0, 8}) == 1);
}

TEST_CASE("a test of several has a stricter level") {
  // One-sided 99.5 % of four degrees of freedom: 4.604.
  CHECK(outcome_above_zero({4.61, 1, 5}, 0.995) == Outcome::agrees);
  CHECK(outcome_above_zero({4.60, 1, 5}, 0.995) == Outcome::within_scatter);
}
