// SPDX-License-Identifier: BSL-1.0
#include "samples.hpp"

#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>

namespace report {

Estimate estimate(const std::vector<double>& values) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (values.empty()) return {none, none, 0};
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  if (values.size() < 2) return {mean, none, values.size()};
  double squares = 0;
  for (const double v : values) squares += (v - mean) * (v - mean);
  return {mean, std::sqrt(squares / (n - 1) / n), values.size()};
}

Estimate correlation(const std::vector<double>& x, const std::vector<double>& y) {
  const double mean_x = estimate(x).mean;
  const double mean_y = estimate(y).mean;
  double xx = 0;
  double xy = 0;
  double yy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - mean_x) * (x[i] - mean_x);
    xy += (x[i] - mean_x) * (y[i] - mean_y);
    yy += (y[i] - mean_y) * (y[i] - mean_y);
  }
  const double r = xx * yy > 0 ? xy / std::sqrt(xx * yy) : 0;
  return {r, std::sqrt((1 - r * r) / (static_cast<double>(x.size()) - 2)), x.size(), 2};
}

Outcome outcome_above_zero(const Estimate& difference) {
  const boost::math::students_t distribution(
      static_cast<double>(difference.samples - difference.fitted));
  const double margin = boost::math::quantile(distribution, 0.95) * difference.standard_error;
  if (difference.mean > margin) return Outcome::agrees;
  if (difference.mean < -margin) return Outcome::against;
  return Outcome::within_scatter;
}

}  // namespace report
