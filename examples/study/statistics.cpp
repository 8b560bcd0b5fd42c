// SPDX-License-Identifier: BSL-1.0
#include "statistics.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

namespace run_study {

double t_quantile(double probability, double degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(degrees_of_freedom), probability);
}

Statistics statistics_of(const std::vector<double>& values) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Statistics s{.mean = none, .standard_deviation = none, .half_interval = none};
  double sum = 0;
  for (const double v : values)
    if (!std::isnan(v)) {
      sum += v;
      ++s.count;
    }
  if (s.count == 0) return s;
  const auto n = static_cast<double>(s.count);
  s.mean = sum / n;
  if (s.count < 2) return s;
  double squares = 0;
  for (const double v : values)
    if (!std::isnan(v)) squares += (v - s.mean) * (v - s.mean);
  s.standard_deviation = std::sqrt(squares / (n - 1));
  s.half_interval = t_quantile(0.975, n - 1) * s.standard_deviation / std::sqrt(n);
  return s;
}

double largest_mean(const std::vector<double>& values, std::size_t window) {
  double largest = 0;
  for (std::size_t i = 0; i + window <= values.size(); ++i) {
    double mean = 0;
    for (std::size_t k = i; k < i + window; ++k) mean += values[k] / static_cast<double>(window);
    largest = std::max(largest, mean);
  }
  return largest;
}

}  // namespace run_study
