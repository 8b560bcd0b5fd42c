// SPDX-License-Identifier: BSL-1.0
#include <study/statistics.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include <support/near.hpp>

using namespace run_study;
using riprap::test::near;
using riprap::test::near_relative;

TEST_CASE("quantiles of Student's t") {
  // Abramowitz and Stegun, table 26.10 (A = 0.95), three decimals.
  struct Row {
    double degrees;
    double t;
  };
  for (const Row& row : {Row{1, 12.706}, Row{2, 4.303}, Row{3, 3.182}, Row{7, 2.365},
                         Row{10, 2.228}, Row{30, 2.042}, Row{120, 1.980}})
    CHECK(std::abs(t_quantile(0.975, row.degrees) - row.t) <= 0.5e-3);
  // Closed forms: tan(pi (p - 1/2)) of one degree, (2p - 1) / sqrt(2 p (1 - p)) of two.
  CHECK(t_quantile(0.975, 1) == near_relative(std::tan(std::acos(-1.0) * 0.475), 1e-12));
  CHECK(t_quantile(0.9, 2) == near_relative(0.8 / std::sqrt(2 * 0.9 * 0.1), 1e-12));
  CHECK(t_quantile(0.5, 4) == near(0, 1e-12));
}

TEST_CASE("the interval of a mean: additional hours of sleep, Student 1908") {
  // Second less first drug for ten patients (Biometrika 6, p. 20); R's t.test of its data set
  // `sleep` gives the interval to seven digits.
  const Statistics s = statistics_of({1.2, 2.4, 1.3, 1.3, 0.0, 1.0, 1.8, 0.8, 4.6, 1.4});
  CHECK(s.count == 10);
  CHECK(s.mean == near_relative(1.58, 1e-12));
  CHECK(s.standard_deviation == near_relative(1.229995, 1e-6));
  CHECK(s.low() == near_relative(0.7001142, 1e-7));
  CHECK(s.high() == near_relative(2.4598858, 1e-7));
}

TEST_CASE("few values, and values that are missing") {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  CHECK(statistics_of({}).count == 0);
  CHECK(std::isnan(statistics_of({none}).mean));
  CHECK(statistics_of({none, 3}).mean == 3);
  CHECK(std::isnan(statistics_of({3}).standard_deviation));
  CHECK(std::isnan(statistics_of({3}).low()));
  // Two values: their mean -+ 12.706 times half their difference.
  const Statistics two = statistics_of({1, none, 2});
  CHECK(two.count == 2);
  CHECK(two.high() == near_relative(1.5 + 12.7062 / 2, 1e-5));
  CHECK(statistics_of({2, 2, 2}).high() == 2);
}

TEST_CASE("the largest mean of neighbouring values") {
  CHECK(largest_mean({1, 4, 2, 6, 3, 0}, 2) == 4.5);
  CHECK(largest_mean({1, 4, 2, 6, 3, 0}, 6) == near(16.0 / 6, 1e-15));
  CHECK(largest_mean({1, 4}, 3) == 0);
}
