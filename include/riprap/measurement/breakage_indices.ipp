// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>

#include <riprap/measurement/breakage_indices.hpp>

namespace riprap {

RIPRAP_INLINE double hardin_breakage(const Grading& before, const Grading& after, double limit) {
  const double potential = before.area_above(limit);
  require_positive("hardin_breakage: area of the first grading above the limit", potential);
  return (potential - after.area_above(limit)) / potential;
}

RIPRAP_INLINE double marsal_breakage(const Grading& before, const Grading& after,
                                     std::span<const double> sieves) {
  require(!sieves.empty(), "marsal_breakage: number of sieves", 0, "must be 1 or more");
  double gained = 0;
  double finer_gain = 0;  // of all that passes the sieve before
  double last = 0;
  for (const double sieve : sieves) {
    require(sieve > last, "marsal_breakage: sieve", sieve, "must be larger than the one before");
    const double gain = after.passing(sieve) - before.passing(sieve);
    gained += std::max(gain - finer_gain, 0.0);
    finer_gain = gain;
    last = sieve;
  }
  return gained + std::max(-finer_gain, 0.0);
}

RIPRAP_INLINE double lade_breakage(const Grading& before, const Grading& after) {
  return 1 - after.size_at(0.10) / before.size_at(0.10);
}

RIPRAP_INLINE double UltimateGrading::area() const {
  return -std::log10(smallest_ratio) -
         (1 - std::pow(smallest_ratio, exponent)) / (exponent * std::log(10.0));
}

RIPRAP_INLINE void UltimateGrading::validate() const {
  require_positive("UltimateGrading.exponent", exponent);
  require(smallest_ratio > 0 && smallest_ratio < 1, "UltimateGrading.smallest_ratio",
          smallest_ratio, "must lie in (0, 1)");
}

RIPRAP_INLINE double einav_breakage(const Grading& before, const Grading& after,
                                    const UltimateGrading& ultimate) {
  ultimate.validate();
  const double finest = ultimate.smallest_ratio * before.largest();
  const double first = before.area_above(finest);
  const double potential = first - ultimate.area();
  require_positive("einav_breakage: area between the first grading and the ultimate one",
                   potential);
  return (first - after.area_above(finest)) / potential;
}

}  // namespace riprap
