// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Gives the particles of an assembly materials at random, by shares of their area.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/ids.hpp>
#include <riprap/core/splitmix64.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/particle/assembly.hpp>

namespace riprap {

/// The free particles, in an order drawn by `seed`, become material 0, 1, ... until each has its
/// share of their area, met to half the area of a particle; all others stay what they are. Cells of
/// a stone are particles: they become of several materials. Samples
/// of one seed with other shares differ in as few particles as can be.
/// @param shares of the materials [-], 0 or above, of sum 1
/// Throws InvalidInput for shares that break the rule.
inline void share_materials(Assembly& assembly, const std::vector<double>& shares,
                            std::uint64_t seed = 1) {
  double sum = 0;
  for (const double share : shares) {
    require_non_negative("share_materials: share", share);
    sum += share;
  }
  require(std::abs(sum - 1) <= 1e-9, "share_materials: sum of the shares", sum, "must be 1");
  std::vector<std::pair<double, std::size_t>> order;
  double total = 0;
  for (std::size_t i = 0; i < assembly.particles.size(); ++i) {
    if (assembly.particles[i].motion != Motion::free) continue;
    order.emplace_back(draw(seed, static_cast<ParticleId>(i)), i);
    total += polygon_area(assembly.particles[i].polygon.ring());
  }
  std::sort(order.begin(), order.end());
  double before = 0;
  double end = shares.front() * total;  // of the present material
  std::size_t material = 0;
  for (const auto& [drawn, i] : order) {
    const double area = polygon_area(assembly.particles[i].polygon.ring());
    while (before + 0.5 * area > end && material + 1 < shares.size())
      end += shares[++material] * total;
    assembly.particles[i].material = static_cast<MaterialIndex>(material);
    before += area;
  }
}

}  // namespace riprap
