// SPDX-License-Identifier: BSL-1.0
#pragma once
// How far measurements lie from those of the reference.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "measurement.hpp"

namespace convergence {

// The share-th quantile of numbers, linear between two of them; not-a-number without any.
[[nodiscard]] inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) return std::nan("");
  std::ranges::sort(values);
  const double place = share * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(place);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (place - static_cast<double>(low)) * (values[high] - values[low]);
}

struct Spread {
  double bias = 0;    // mean
  double median = 0;  // of the absolute values
  double ninth = 0;   // their 90 % quantile
  std::size_t count = 0;
};

// Leaves out what is not a number.
[[nodiscard]] inline Spread spread(const std::vector<double>& values) {
  std::vector<double> sizes;
  double sum = 0;
  for (const double v : values)
    if (!std::isnan(v)) {
      sum += v;
      sizes.push_back(std::abs(v));
    }
  return {sum / static_cast<double>(sizes.size()), quantile(sizes, 0.5), quantile(sizes, 0.9),
          sizes.size()};
}

[[nodiscard]] inline double load_error(const Measurement& m) {
  return std::log(m.load / m.reference_load);
}
[[nodiscard]] inline double calibrated_load_error(const Measurement& m) {
  return std::log(m.calibrated_load / m.reference_load);
}
// Between two lines [degrees], 0 to 90.
[[nodiscard]] inline double angle_error(const Measurement& m, std::size_t line) {
  const double turned = std::abs(std::fmod(m.angles[line] - m.reference_angles[line], 180.0));
  return std::min(turned, 180 - turned);
}

[[nodiscard]] inline std::string text(const char* format, double value) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, format, value);
  return std::isnan(value) ? "-" : buffer;
}
// "bias, median, 90 %"
[[nodiscard]] inline std::string text(const Spread& s) {
  if (s.count == 0) return "-";
  return text("%+.2f", s.bias) + ", " + text("%.2f", s.median) + ", " + text("%.2f", s.ninth);
}

}  // namespace convergence
