// SPDX-License-Identifier: BSL-1.0
#pragma once
// Means of few values, with the interval that Student's t gives them.

#include <cstddef>
#include <vector>

namespace run_study {

// t of the probability p with nu degrees of freedom.
double t_quantile(double probability, double degrees_of_freedom);

// Values that are not-a-number do not count.
struct Statistics {
  std::size_t count = 0;
  double mean;                // not-a-number without values
  double standard_deviation;  // of the values, n - 1 below; not-a-number of less than two
  double half_interval;       // mean -+ it is the 95 % interval of the expected value; likewise

  [[nodiscard]] double low() const { return mean - half_interval; }
  [[nodiscard]] double high() const { return mean + half_interval; }
};
Statistics statistics_of(const std::vector<double>& values);

// The largest mean of so many neighbouring values; 0 where there are fewer, or all are below 0.
double largest_mean(const std::vector<double>& values, std::size_t window);

}  // namespace run_study
