// SPDX-License-Identifier: BSL-1.0
#include "results.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace shear_tests {

namespace {
constexpr double degree = std::numbers::pi / 180;
}

std::string colour(std::size_t k) {
  constexpr std::array colours{"#1f6fb4", "#15803d", "#c0392b", "#a06cc0", "#b8860b", "#444444"};
  return colours[k % colours.size()];
}

Envelope envelope(const std::vector<riprap::Vec2>& points) {
  double products = 0;
  double squares = 0;
  bool several = false;
  for (const auto& p : points) {
    products += p.x() * p.y();
    squares += p.x() * p.x();
    several = several || p.x() != points.front().x();
  }
  Envelope e{.cohesion = std::nan(""), .angle = std::nan("")};
  e.secant_angle = std::atan(products / squares) / degree;
  if (!several) return e;
  const riprap::RegressionLine line = riprap::regression_line(points);
  e.cohesion = line.intercept;
  e.angle = std::atan(line.slope) / degree;
  return e;
}

StraightLine straight_line(const std::vector<riprap::Vec2>& points) {
  const auto n = static_cast<double>(points.size());
  double mean = 0;
  for (const auto& p : points) mean += p.y() / n;
  double variance = 0;
  for (const auto& p : points) variance += (p.y() - mean) * (p.y() - mean) / n;
  const riprap::RegressionLine line = riprap::regression_line(points);
  return {line, 1 - line.scatter * line.scatter / variance};
}

std::vector<riprap::Vec2> mean_curve(const std::vector<std::vector<riprap::Vec2>>& curves) {
  std::size_t count = curves.front().size();
  for (const auto& c : curves) count = std::min(count, c.size());
  std::vector<riprap::Vec2> mean(count, riprap::Vec2{0, 0});
  for (const auto& c : curves)
    for (std::size_t i = 0; i < count; ++i) mean[i] += c[i] / static_cast<double>(curves.size());
  return mean;
}

std::vector<riprap::Vec2> bin_means(const std::vector<riprap::Vec2>& points, double low,
                                    double high, std::size_t bins) {
  std::vector<double> sums(bins, 0);
  std::vector<unsigned> counts(bins, 0);
  const double width = (high - low) / static_cast<double>(bins);
  for (const auto& p : points) {
    if (p.x() < low || p.x() >= high) continue;
    const std::size_t k = std::min(static_cast<std::size_t>((p.x() - low) / width), bins - 1);
    sums[k] += p.y();
    ++counts[k];
  }
  std::vector<riprap::Vec2> means;
  for (std::size_t k = 0; k < bins; ++k)
    if (counts[k] > 0)
      means.push_back({low + (static_cast<double>(k) + 0.5) * width, sums[k] / counts[k]});
  return means;
}

double major_direction(const riprap::Stress2& stress) {
  const riprap::Vec2 major = stress.principal().major_direction;
  const double angle = std::atan2(major.y(), major.x()) / degree;
  return angle < 0 ? angle + 180 : angle >= 180 ? angle - 180 : angle;
}

double major_direction_of_rate(double contraction) {
  return major_direction({.s11 = 0, .s22 = contraction, .s12 = -0.5});
}

std::string interval_text(const run_study::Statistics& s, int decimals) {
  char text[80];
  if (s.count > 1)
    std::snprintf(text, sizeof text, "%.*f -+ %.*f", decimals, s.mean, decimals, s.half_interval);
  else
    std::snprintf(text, sizeof text, "%.*f", decimals, s.mean);
  return text;
}

Json to_json(const run_study::Statistics& s) {
  Json j = {{"samples", s.count}, {"mean", s.mean}};
  if (s.count > 1) j["half_interval_95"] = s.half_interval;
  return j;
}

}  // namespace shear_tests
