// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <riprap/particle/spatial_order.hpp>

namespace riprap {

namespace internal {

RIPRAP_INLINE std::uint64_t morton_code(std::uint32_t column, std::uint32_t row) {
  std::uint64_t place = 0;
  for (unsigned bit = 0; bit < 32; ++bit) {
    place |= std::uint64_t{(column >> bit) & 1U} << (2 * bit);
    place |= std::uint64_t{(row >> bit) & 1U} << (2 * bit + 1);
  }
  return place;
}

}  // namespace internal

RIPRAP_INLINE void sort_by_morton_code(std::span<PlacedParticle> particles) {
  if (particles.empty()) return;
  std::vector<Vec2> centres;
  Vec2 low = area_properties(particles[0].polygon.ring()).centroid;
  Vec2 high = low;
  for (const PlacedParticle& p : particles) {
    centres.push_back(area_properties(p.polygon.ring()).centroid);
    low = componentwise_min(low, centres.back());
    high = componentwise_max(high, centres.back());
  }
  // Finer than any particle.
  const double cells = 65536 / std::max({high.x() - low.x(), high.y() - low.y(), 1e-300});
  std::vector<double> places;  // whole numbers, exact: 34 bits at most
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Vec2 at = cells * (centres[i] - low);
    places.push_back(static_cast<double>(internal::morton_code(
        static_cast<std::uint32_t>(at.x()), static_cast<std::uint32_t>(at.y()))));
  }
  std::vector<PlacedParticle> sorted;
  for (const std::size_t i : argsort(places)) sorted.push_back(std::move(particles[i]));
  std::move(sorted.begin(), sorted.end(), particles.begin());
}

}  // namespace riprap
