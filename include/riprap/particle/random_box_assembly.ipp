// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <riprap/particle/placement_grid.hpp>
#include <riprap/particle/random_box_assembly.hpp>

namespace riprap {

namespace internal {

/// A place in a square of half side `half` about the origin.
[[nodiscard]] RIPRAP_INLINE Vec2 place_in_square(double half, Random& random) {
  const double x = random.uniform(-half, half);
  return {x, random.uniform(-half, half)};
}

}  // namespace internal

RIPRAP_INLINE Assembly random_platen_assembly(const RandomAssembly& options) {
  options.validate();
  Random random(options.seed);
  internal::RandomPolygons made = internal::random_polygons(options, random);
  const double half = 0.5 * std::sqrt(made.area / options.solid_fraction);

  Assembly assembly{.thickness = options.thickness, .particles = {}};
  const double d = internal::mean_diameter(options);
  const double end = 2 * half;
  const ConvexPolygon right{{half, -end}, {half + d, -end}, {half + d, end}, {half, end}};
  for (const Rotation& side : {Rotation{1, 0}, Rotation{-1, 0}, Rotation{0, 1}, Rotation{0, -1}})
    assembly.particles.push_back({right.moved(side, {0, 0}), Motion::platen});
  internal::place_at_random(
      made, assembly, [&] { return internal::place_in_square(half, random); },
      [half](const internal::PlacementGrid& placed, const ConvexPolygon& candidate,
             const Vec2& centre) {
        for (const Vec2& v : candidate)
          if (v.cwiseAbs().maxCoeff() >= half) return false;
        return placed.is_clear(candidate.ring(), centre);
      });
  return assembly;
}

RIPRAP_INLINE Assembly random_periodic_assembly(const RandomAssembly& options) {
  options.validate();
  Random random(options.seed);
  internal::RandomPolygons made = internal::random_polygons(options, random);
  const double side = std::sqrt(made.area / options.solid_fraction);

  Assembly assembly{.thickness = options.thickness, .particles = {}, .period = {side, side}};
  internal::place_at_random(
      made, assembly, [&] { return internal::place_in_square(0.5 * side, random); },
      [side](const internal::PlacementGrid& placed, const ConvexPolygon& candidate,
             const Vec2& centre) {
        for (int i = -1; i <= 1; ++i)
          for (int j = -1; j <= 1; ++j) {
            const Vec2 offset{i * side, j * side};
            if (!placed.is_clear(candidate.moved({}, offset).ring(), centre + offset)) return false;
          }
        return true;
      });
  return assembly;
}

}  // namespace riprap
