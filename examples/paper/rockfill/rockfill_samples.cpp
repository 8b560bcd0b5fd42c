// SPDX-License-Identifier: BSL-1.0
#include "rockfill_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include <riprap/core/errors.hpp>

namespace rockfill {

namespace {

constexpr std::array modes{"nb", "wb"};

// Throws for any other mode.
std::size_t rank(const std::string& mode) {
  const auto found = std::find(modes.begin(), modes.end(), mode);
  if (found == modes.end())
    throw riprap::InvalidInput("mode \"" + mode + "\" of a run must be nb or wb");
  return static_cast<std::size_t>(found - modes.begin());
}

// JSON has no NaN: it is written as null.
double real(const Json& value) {
  return value.is_null() ? std::numeric_limits<double>::quiet_NaN() : value.get<double>();
}

std::vector<double> column(const Json& table, const std::string& name, std::size_t length) {
  std::vector<double> values;
  for (const Json& v : table.at(name)) values.push_back(real(v));
  riprap::require(values.size() == length, "number of values of " + name,
                  static_cast<double>(values.size()), "must be that of its table's first column");
  return values;
}

// Largest mean over records within 1 % of strain of one of them.
riprap::SecantStrength peak_strength(const std::vector<double>& strain,
                                     const std::vector<double>& sin_phi,
                                     const std::vector<double>& minor) {
  double peak = -1;
  double minor_at_peak = 0;
  for (const double at : strain) {
    double count = 0;
    double sum = 0;
    double minor_sum = 0;
    for (std::size_t i = 0; i < strain.size(); ++i) {
      // A small tolerance, so that a record at the limit counts whatever its last bits.
      if (std::abs(strain[i] - at) > 0.0101 || std::isnan(sin_phi[i])) continue;
      ++count;
      sum += sin_phi[i];
      minor_sum += minor[i];
    }
    if (count > 0 && sum / count > peak) {
      peak = sum / count;
      minor_at_peak = minor_sum / count;
    }
  }
  return riprap::secant_strength(peak, minor_at_peak);
}

riprap::Grading grading(const Json& table, const std::string& name) {
  const std::size_t length = table.at("size_m").size();
  const std::vector<double> size = column(table, "size_m", length);
  const std::vector<double> finer = column(table, name, length);
  std::vector<riprap::GradingPoint> points;
  for (std::size_t i = 0; i < length; ++i) points.push_back({size[i], finer[i]});
  return riprap::Grading::of_sieves(points);
}

}  // namespace

Sample read_sample(const Json& run) {
  const Json& curve = run.at("curve");
  const std::size_t length = curve.at("axial_strain").size();
  riprap::require(length >= 2, "number of records of a run", static_cast<double>(length),
                  "must be 2 or more");
  const std::vector<double> strain = column(curve, "axial_strain", length);
  const std::vector<double> minor = column(curve, "sigma_11_Pa", length);
  const std::vector<double> major = column(curve, "sigma_22_Pa", length);
  const std::vector<double> porosity = column(curve, "porosity", length);
  std::vector<riprap::Vec2> deviator;
  for (std::size_t i = 0; i < length; ++i) deviator.push_back({strain[i], major[i] - minor[i]});
  const Json& gradings = run.at("grading");
  const std::string mode = run.at("mode");
  (void)rank(mode);
  return {mode,
          run.at("pressure_Pa").get<double>(),
          peak_strength(strain, column(curve, "sin_phi", length), minor),
          riprap::secant_modulus_at_share(deviator),
          porosity.front(),
          porosity.back(),
          real(gradings.at("marsal_b_g")),
          grading(gradings, "finer_before"),
          grading(gradings, "finer_after")};
}

Statistic Group::statistic_of(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  double mean = 0;
  for (const double v : values) mean += v / count;
  double squares = 0;
  for (const double v : values) squares += (v - mean) * (v - mean);
  return {mean, count > 1 ? std::sqrt(squares / (count - 1)) : 0};
}

std::vector<Group> grouped(const std::vector<Json>& runs) {
  std::vector<Group> groups;
  for (const Json& run : runs) {
    Sample sample = read_sample(run);
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const Group& g) {
      return g.mode == sample.mode && g.pressure == sample.pressure;
    });
    if (same != groups.end())
      same->samples.push_back(std::move(sample));
    else
      groups.push_back({sample.mode, sample.pressure, {sample}});
  }
  std::sort(groups.begin(), groups.end(), [](const Group& a, const Group& b) {
    return std::tuple(rank(a.mode), a.pressure) < std::tuple(rank(b.mode), b.pressure);
  });
  return groups;
}

std::vector<riprap::GradingPoint> mean_grading(const std::vector<riprap::Grading>& curves,
                                               int count) {
  double finest = std::numeric_limits<double>::infinity();
  double coarsest = 0;
  for (const riprap::Grading& g : curves) {
    finest = std::min(finest, g.points().front().size);
    coarsest = std::max(coarsest, g.points().back().size);
  }
  std::vector<riprap::GradingPoint> mean;
  for (int k = 0; k < count && coarsest > 0; ++k) {
    const double size =
        k + 1 == count ? coarsest : finest * std::pow(coarsest / finest, k / (count - 1.0));
    double passing = 0;
    for (const riprap::Grading& g : curves)
      passing += g.passing(size) / static_cast<double>(curves.size());
    mean.push_back({size, passing});
  }
  return mean;
}

}  // namespace rockfill
