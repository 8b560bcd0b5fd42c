// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include <riprap/particle/placement_grid.hpp>
#include <riprap/particle/random_assembly.hpp>

namespace riprap {

namespace internal {

/// Extent of a polygon across the direction from the origin to `at`.
RIPRAP_INLINE double tangential_extent(const ConvexPolygon& polygon, const Vec2& at) {
  const Vec2 tangent = perpendicular(at) / at.norm();
  double low = 0;
  double high = 0;
  for (const Vec2& v : polygon) {
    low = std::min(low, tangent.dot(v));
    high = std::max(high, tangent.dot(v));
  }
  return high - low;
}

/// Polygons one after the other round the circle, each with the arc it needs. Moves the first few
/// of `polygons` into the assembly; the ring closes at `dense_radius` and is placed at `radius`.
RIPRAP_INLINE void place_ring(std::vector<ConvexPolygon>& polygons, double dense_radius,
                              double radius, double spacing, Assembly& assembly) {
  constexpr double two_pi = 2 * std::numbers::pi;
  std::vector<double> arcs;
  double length = 0;
  while (arcs.size() + 1 < polygons.size() && length < two_pi * dense_radius) {
    const Rotation at = Rotation::from_angle(length / dense_radius);
    arcs.push_back(spacing * tangential_extent(polygons[arcs.size()], {at.cosine, at.sine}));
    length += arcs.back();
  }
  double begun = 0;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const Rotation at = Rotation::from_angle(two_pi * (begun + 0.5 * arcs[i]) / length);
    const Vec2 centre = radius * Vec2{at.cosine, at.sine};
    assembly.particles.push_back({polygons[i].moved({}, centre), Motion::strain_field});
    begun += arcs[i];
  }
  polygons.erase(polygons.begin(), polygons.begin() + static_cast<std::ptrdiff_t>(arcs.size()));
}

}  // namespace internal

RIPRAP_INLINE Assembly random_assembly(const RandomAssembly& options) {
  options.validate();
  require(options.aspect_ratio == 1, "RandomAssembly.aspect_ratio", options.aspect_ratio,
          "must be 1 for a ring");
  Random random(options.seed);
  const double d = internal::mean_diameter(options);
  internal::RandomPolygons random_ones = internal::random_polygons(options, random);
  const double dense_radius =
      std::sqrt(random_ones.area / (std::numbers::pi * options.dense_fraction));
  const double radius = std::sqrt(random_ones.area / (std::numbers::pi * options.solid_fraction));

  Assembly assembly{.thickness = options.thickness, .particles = {}};
  internal::place_ring(random_ones.polygons, dense_radius, radius, options.boundary_spacing,
                       assembly);
  // Nothing may start outside the ring of boundary centroids.
  const double reach = radius - 0.5 * d;
  internal::place_at_random(
      random_ones, assembly,
      [&] {
        const double r = reach * std::sqrt(random.uniform(0, 1));
        const Rotation at = Rotation::from_angle(random.uniform(0, 2 * std::numbers::pi));
        return Vec2(r * Vec2{at.cosine, at.sine});
      },
      [](const internal::PlacementGrid& placed, const ConvexPolygon& candidate,
         const Vec2& centre) { return placed.is_clear(candidate.ring(), centre); });
  return assembly;
}

}  // namespace riprap
