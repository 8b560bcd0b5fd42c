// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>

#include <riprap/particle/placement_grid.hpp>
#include <riprap/particle/random_box_assembly.hpp>

namespace riprap {

namespace internal {

RIPRAP_INLINE Assembly four_platens(const RandomAssembly& options, const Vec2& half) {
  Assembly assembly{.thickness = options.thickness, .particles = {}};
  const double d = mean_diameter(options);
  // On the right, for a rectangle that extends by `to_face` along axis 1.
  const auto platen = [d](double to_face, double across) {
    const double end = 2 * across;
    return ConvexPolygon{{to_face, -end}, {to_face + d, -end}, {to_face + d, end}, {to_face, end}};
  };
  for (const double side : {1.0, -1.0})
    assembly.particles.push_back(
        {platen(half.x(), half.y()).moved(Rotation{side, 0}, {0, 0}), options.walls});
  for (const double side : {1.0, -1.0})
    assembly.particles.push_back(
        {platen(half.y(), half.x()).moved(Rotation{0, side}, {0, 0}), options.walls});
  return assembly;
}

}  // namespace internal

RIPRAP_INLINE Assembly random_platen_assembly(const RandomAssembly& options) {
  options.validate();
  Random random(options.seed);
  internal::RandomPolygons made = internal::random_polygons(options, random);
  const Vec2 half =
      internal::half_extents(made.area / options.solid_fraction, options.aspect_ratio);

  Assembly assembly = internal::four_platens(options, half);
  internal::place_at_random(
      made, assembly, [&] { return internal::place_in_box(half, random); },
      [half](const internal::PlacementGrid& placed, const ConvexPolygon& candidate,
             const Vec2& centre) {
        return internal::lies_in_box(candidate.ring(), half) &&
               placed.is_clear(candidate.ring(), centre);
      });
  return assembly;
}

RIPRAP_INLINE Assembly random_periodic_assembly(const RandomAssembly& options) {
  options.validate();
  Random random(options.seed);
  internal::RandomPolygons made = internal::random_polygons(options, random);
  const Vec2 half =
      internal::half_extents(made.area / options.solid_fraction, options.aspect_ratio);
  const Vec2 period = 2 * half;

  Assembly assembly{.thickness = options.thickness, .particles = {}, .period = period};
  internal::place_at_random(
      made, assembly, [&] { return internal::place_in_box(half, random); },
      [period](const internal::PlacementGrid& placed, const ConvexPolygon& candidate,
               const Vec2& centre) {
        return internal::is_clear_of_images(placed, candidate, centre, period);
      });
  return assembly;
}

}  // namespace riprap
