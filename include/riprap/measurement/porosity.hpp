// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// How much of a sample is empty.

#include <riprap/core/compiler.hpp>

namespace riprap {

/// Pores over the whole [-]. Rock counted twice where particles in contact overlap is taken off.
/// @param region of the sample: what `region(particles)` of a SampleBoundary returns
template <class Region, class Contacts>
[[nodiscard]] double porosity(const Region& region, const Contacts& contacts) {
  double rock = region.solid_area();
  contacts.for_each_touching([&rock](const auto& c) { rock -= c.geometry.area; });
  return 1 - rock / region.area();
}

}  // namespace riprap
