// SPDX-License-Identifier: BSL-1.0
#include "samples.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>
#include <numeric>

namespace report {

namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

boost::math::students_t distribution_of(const Estimate& e) {
  return boost::math::students_t(static_cast<double>(e.samples) - 1);
}

double half_width(const Estimate& e, double level) {
  return boost::math::quantile(distribution_of(e), level) * e.standard_error;
}

}  // namespace

Estimate estimate(const std::vector<double>& values) {
  if (values.empty()) return {none, none, 0};
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  if (values.size() < 2) return {mean, none, values.size()};
  double squares = 0;
  for (const double v : values) squares += (v - mean) * (v - mean);
  return {mean, std::sqrt(squares / (n - 1) / n), values.size()};
}

double correlation(const std::vector<double>& x, const std::vector<double>& y) {
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
  return xx * yy > 0 ? xy / std::sqrt(xx * yy) : 0;
}

Outcome outcome_above_zero(const Estimate& difference, double level) {
  const double width = half_width(difference, level);
  if (difference.mean > width) return Outcome::agrees;
  if (difference.mean < -width) return Outcome::against;
  return Outcome::within_scatter;
}

Estimate pooled(const std::vector<Cell>& cells, const std::vector<double>& weights) {
  std::vector<double> contrasts;
  if (cells.empty()) return estimate(contrasts);
  for (const auto& [sample, first] : cells.front()) {
    double sum = 0;
    for (std::size_t k = 0; k < cells.size(); ++k) {
      const auto found = cells[k].find(sample);
      sum += weights.at(k) * (found == cells[k].end() ? none : found->second);
    }
    if (!std::isnan(sum)) contrasts.push_back(sum);
  }
  return estimate(contrasts);
}

std::vector<double> mean_weights(std::size_t cells) {
  return std::vector<double>(cells, 1 / static_cast<double>(cells));
}

std::vector<double> slope_weights(const std::vector<double>& x) {
  const double mean = estimate(x).mean;
  double squares = 0;
  for (const double v : x) squares += (v - mean) * (v - mean);
  std::vector<double> weights;
  for (const double v : x) weights.push_back((v - mean) / squares);
  return weights;
}

Shown shown_by(const Estimate& effect, double margin) {
  const double width = half_width(effect, test_level);
  const bool is_small = margin > 0 && effect.mean + width < margin;
  if (effect.mean > width) return is_small ? Shown::small_effect : Shown::effect;
  if (effect.mean < -width) return Shown::opposite;
  return is_small ? Shown::no_effect : Shown::neither;
}

double p_value(const Estimate& effect) {
  if (effect.standard_error == 0) return effect.mean > 0 ? 0 : effect.mean < 0 ? 1 : 0.5;
  return boost::math::cdf(
      boost::math::complement(distribution_of(effect), effect.mean / effect.standard_error));
}

}  // namespace report
