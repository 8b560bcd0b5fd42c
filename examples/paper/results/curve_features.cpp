// SPDX-License-Identifier: BSL-1.0
#include "curve_features.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace report {

namespace {

// A small tolerance, so that a record at a limit counts whatever its last bits.
constexpr double hair = 1e-4;

std::vector<double> smoothed(const Run& run, const std::string& column) {
  std::vector<double> out;
  for (const double strain : run.column("axial_strain"))
    out.push_back(mean_between(run, column, strain - 0.01, strain + 0.01));
  return out;
}

}  // namespace

double mean_between(const Run& run, const std::string& column, double from, double to) {
  const auto& strain = run.column("axial_strain");
  const auto& values = run.column(column);
  double sum = 0;
  double count = 0;
  for (std::size_t i = 0; i < strain.size(); ++i)
    if (strain[i] >= from - hair && strain[i] <= to + hair) {
      sum += values[i];
      ++count;
    }
  return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

double at_start(const Run& run, const std::string& column) { return run.column(column).front(); }

double at_end(const Run& run, const std::string& column) {
  const double end = run.column("axial_strain").back();
  return mean_between(run, column, end - 0.05, end);
}

double largest(const Run& run, const std::string& column) {
  const auto& values = run.column(column);
  return *std::max_element(values.begin(), values.end());
}

Peak smooth_peak(const Run& run, const std::string& column) {
  const std::vector<double> values = smoothed(run, column);
  const auto top = std::max_element(values.begin(), values.end());
  return {*top, run.column("axial_strain")[static_cast<std::size_t>(top - values.begin())]};
}

double strain_at_share_of_peak(const Run& run, const std::string& column, double share) {
  const std::vector<double> values = smoothed(run, column);
  const double limit = share * *std::max_element(values.begin(), values.end());
  const auto first =
      std::find_if(values.begin(), values.end(), [&](double v) { return v >= limit; });
  return run.column("axial_strain")[static_cast<std::size_t>(first - values.begin())];
}

double loss_after_peak(const Run& run, const std::string& column) {
  const Peak peak = smooth_peak(run, column);
  if (peak.strain > run.column("axial_strain").back() - 0.05) return 0;
  return 1 - at_end(run, column) / peak.value;
}

double mean_gap(const Run& run, const std::string& prediction) {
  const auto& strain = run.column("axial_strain");
  const auto& measured = run.column("sin_phi");
  const auto& predicted = run.column(prediction);
  double sum = 0;
  double count = 0;
  for (std::size_t i = 0; i < strain.size(); ++i)
    if (strain[i] >= 0.01 - hair) {
      sum += std::abs(predicted[i] - measured[i]);
      ++count;
    }
  return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace report
