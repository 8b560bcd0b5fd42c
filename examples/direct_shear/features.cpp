// SPDX-License-Identifier: BSL-1.0
#include "features.hpp"

#include <algorithm>
#include <cmath>

#include <riprap/core/errors.hpp>

namespace direct_shear {

namespace {

constexpr std::size_t window = 5;  // records

// Mean over the records from `first` up to `last`.
Strength mean(const BoxResult& r, std::size_t first, std::size_t last) {
  Strength s;
  const double share = 1 / static_cast<double>(last - first);
  for (std::size_t i = first; i < last; ++i) {
    s.displacement += share * r.records[i].displacement;
    s.normal += share * r.records[i].forces.normal_plane / r.area();
    s.shear += share * r.records[i].forces.shear_lower / r.area();
  }
  return s;
}

}  // namespace

Features features(const BoxResult& r) {
  const std::size_t count = r.records.size();
  riprap::require(count >= window, "number of records", static_cast<double>(count),
                  "must be 5 or more");
  Features f;
  std::size_t peak = 0;
  for (std::size_t i = 0; i + window <= count; ++i) {
    const Strength s = mean(r, i, i + window);
    if (i > 0 && s.ratio() <= f.peak.ratio()) continue;
    f.peak = s;
    peak = i;
  }
  f.end = mean(r, count - std::max<std::size_t>(count / 5, 1), count);
  const std::size_t first = peak < window ? 0 : peak - window;
  const std::size_t last = std::min(peak + 2 * window, count) - 1;
  f.dilation = (r.records[last].lift - r.records[first].lift) /
               (r.records[last].displacement - r.records[first].displacement);
  BoxForces sum;
  for (const Record& rec : r.records) {
    f.imbalance += std::abs(rec.forces.shear_lower - rec.forces.shear_upper);
    sum += rec.forces;
  }
  const double shear = 0.5 * (sum.shear_lower + sum.shear_upper);
  f.imbalance /= shear;
  f.mean_offset = (sum.shear_lower - sum.shear_upper) / shear;
  f.plane_over_lid = sum.normal_plane / sum.normal_lid;
  return f;
}

}  // namespace direct_shear
