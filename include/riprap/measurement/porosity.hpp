// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// How much of a sample is empty.

#include <array>

#include <riprap/measurement/contact_sum.hpp>

namespace riprap {

/// Pores over the whole [-]. Rock counted twice where particles in contact overlap is taken off.
/// @param region of the sample: what `region(particles)` of a SampleBoundary returns
template <class Region, class Contacts>
[[nodiscard]] double porosity(const Region& region, const Contacts& contacts) {
  const double twice =
      sum_over_contacts<1>(contacts, [](const auto& c) { return std::array{c.geometry.area}; })[0];
  return 1 - (region.solid_area() - twice) / region.area();
}

/// Pores over solids [-], of a porosity below 1.
[[nodiscard]] inline double void_ratio(double porosity) { return porosity / (1 - porosity); }

}  // namespace riprap
