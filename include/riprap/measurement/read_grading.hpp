// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Reads a grading curve from a file, and gives a sample of particles the sizes that follow it.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <istream>
#include <string>
#include <utility>
#include <vector>

#include <riprap/core/read_csv.hpp>
#include <riprap/measurement/grading.hpp>

namespace riprap {

/// The grading of a table with the header `size,passing`: the openings of the sieves [m], 0.02 for
/// one of 20 mm, ascending, and the share of the mass that passes them [-], 1 at the last one.
/// Throws InvalidInput with the name of the file, the line, the value and the rule for anything
/// else; sizes in millimetres are no error here, but a warning of ValidityCheck.
[[nodiscard]] inline Grading read_grading(std::istream& in, const std::string& name) {
  internal::CsvReader rows(in, name, "size,passing");
  std::vector<GradingPoint> points;
  while (rows.next()) {
    const GradingPoint p{rows.number(0), rows.number(1)};
    if (!(p.size > 0)) rows.fail(0, "must be above 0");
    const bool is_share = p.passing >= 0 && p.passing <= 1;
    if (!is_share) rows.fail(1, "must lie in [0, 1]");
    if (!points.empty() && p.size < points.back().size) rows.fail(0, "must not descend");
    if (!points.empty() && p.passing < points.back().passing) rows.fail(1, "must not descend");
    points.push_back(p);
  }
  if (points.empty()) throw InvalidInput(name + ": no sieves: must have one or more");
  if (points.back().passing != 1) rows.fail(1, "must be 1 in the last row");
  return Grading::of_sieves(std::move(points));
}

/// The same from a file. Throws InvalidInput also where it cannot be read, with the reason.
[[nodiscard]] inline Grading read_grading(const std::filesystem::path& path) {
  auto file = internal::open_text(path);
  return read_grading(file, path.string());
}

namespace internal {

/// Number of particles, over the mass of all over the mass of one of size 1 m, between two points
/// of a grading. Mass is spread evenly over the logarithm of size s, and the mass of a particle is
/// proportional to s^2: dn = slope * s^-2 d(ln s).
struct GradedInterval {
  double smallest = 0;  ///< [m]
  double largest = 0;   ///< [m]
  double count = 0;

  GradedInterval(const GradingPoint& from, const GradingPoint& to)
      : smallest(from.size), largest(to.size) {
    const double share = to.passing - from.passing;
    const double width = std::log(largest / smallest);
    count = share / (smallest * smallest);
    // expm1 keeps the digits of narrow intervals.
    if (width > 0) count *= -std::expm1(-2 * width) / (2 * width);
  }
  /// Size [m] that this share of the particles of the interval does not exceed.
  [[nodiscard]] double size_at(double share) const {
    const double ratio = smallest / largest;
    return smallest / std::sqrt(1 - share * (1 - ratio * ratio));
  }
};

}  // namespace internal

/// Equivalent diameters [m], ascending, of `count` particles of one thickness and density whose
/// masses follow a grading: the middles of `count` equal shares of the number of particles. The
/// curve of the sample departs from the grading by about the mass of its largest particle.
[[nodiscard]] inline std::vector<double> graded_diameters(const Grading& grading,
                                                          std::size_t count) {
  std::vector<internal::GradedInterval> intervals;
  GradingPoint before{grading.points().front().size, 0};
  for (const GradingPoint& p : grading.points()) {
    if (p.passing > before.passing) intervals.emplace_back(before, p);
    before = p;
  }
  double total = 0;
  for (const internal::GradedInterval& interval : intervals) total += interval.count;
  std::vector<double> diameters;
  std::size_t k = 0;
  double passed = 0;  // particles of the intervals before k
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = total * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    while (k + 1 < intervals.size() && passed + intervals[k].count <= wanted)
      passed += intervals[k++].count;
    const double share = (wanted - passed) / intervals[k].count;
    diameters.push_back(intervals[k].size_at(std::min(share, 1.0)));
  }
  return diameters;
}

}  // namespace riprap
