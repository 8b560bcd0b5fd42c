// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>

#include <riprap/measurement/force_distribution.hpp>

namespace riprap {

namespace internal {

/// Throws InvalidInput unless forces and their mean are as they should be.
[[nodiscard]] inline double mean_force(std::span<const double> forces) {
  double sum = 0;
  for (const double f : forces) {
    require_non_negative("force of a contact", f);
    sum += f;
  }
  const double mean = forces.empty() ? 0 : sum / static_cast<double>(forces.size());
  require_positive("mean of the forces", mean);
  return mean;
}

}  // namespace internal

RIPRAP_INLINE void ForceBins::validate() const {
  require(count > 0, "ForceBins.count", static_cast<double>(count), "must be 1 or more");
  require_non_negative("ForceBins.first", first);
  if (logarithmic) require_positive("ForceBins.first of logarithmic bins", first);
  require(std::isfinite(last) && last > first, "ForceBins.last", last, "must be above the first");
}

RIPRAP_INLINE std::vector<double> ForceBins::bounds() const {
  validate();
  std::vector<double> out;
  for (std::size_t k = 0; k <= count; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(count);
    out.push_back(logarithmic ? first * std::pow(last / first, share)
                              : first + share * (last - first));
  }
  out.back() = last;
  return out;
}

RIPRAP_INLINE ForceDistribution force_distribution(std::span<const double> forces,
                                                   const ForceBins& bins) {
  ForceDistribution out{.mean = internal::mean_force(forces), .forces = forces.size()};
  out.bounds = bins.bounds();
  out.counts.assign(bins.count, 0);
  for (const double f : forces) {
    const auto above = std::upper_bound(out.bounds.begin(), out.bounds.end(), f / out.mean);
    if (above == out.bounds.begin() || above == out.bounds.end()) continue;
    ++out.counts[static_cast<std::size_t>(above - out.bounds.begin()) - 1];
  }
  for (std::size_t k = 0; k < bins.count; ++k)
    out.density.push_back(
        static_cast<double>(out.counts[k]) /
        (static_cast<double>(forces.size()) * (out.bounds[k + 1] - out.bounds[k])));
  return out;
}

RIPRAP_INLINE ExponentialTail exponential_tail(std::span<const double> forces, double from) {
  require_non_negative("exponential_tail: from", from);
  const double mean = internal::mean_force(forces);
  ExponentialTail out;
  double excess = 0;
  for (const double f : forces) {
    if (f / mean <= from) continue;
    excess += f / mean - from;
    ++out.forces;
  }
  if (out.forces == 0) return out;
  const auto n = static_cast<double>(out.forces);
  out.rate = n / excess;
  out.standard_error = out.rate / std::sqrt(n);
  return out;
}

}  // namespace riprap
