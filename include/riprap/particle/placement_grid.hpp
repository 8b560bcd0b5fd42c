// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// How random assemblies are placed. Of use to them alone.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include <riprap/core/argsort.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/core/random.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/particle/random_placement.hpp>
#include <riprap/particle/spatial_order.hpp>

namespace riprap::internal {

/// Random polygons that are to be placed.
struct RandomPolygons {
  std::vector<ConvexPolygon> polygons;  ///< about their own centroids
  double area = 0;                      ///< of all [m^2]
  double farthest = 0;                  ///< vertex from its centroid [m]
};

/// The mean of the given diameters, or the mean diameter of the options [m].
[[nodiscard]] double mean_diameter(const RandomAssembly& options);

/// Diameters [m] of all particles: those of the options in random order, or from their range.
[[nodiscard]] std::vector<double> random_diameters(const RandomAssembly& options, Random& random);

[[nodiscard]] RandomPolygons random_polygons(const RandomAssembly& options, Random& random);

/// Half width and half height of a rectangle [m].
/// @param area [m^2], @param aspect_ratio width over height [-]
[[nodiscard]] inline Vec2 half_extents(double area, double aspect_ratio) {
  const double half = 0.5 * std::sqrt(area);
  const double stretch = std::sqrt(aspect_ratio);
  return {half * stretch, half / stretch};
}

/// A place in a rectangle about the origin.
/// @param half of its width and height [m]
[[nodiscard]] inline Vec2 place_in_box(const Vec2& half, Random& random) {
  const double x = random.uniform(-half.x(), half.x());
  return {x, random.uniform(-half.y(), half.y())};
}

/// Buckets of placed polygons, so that a new one is tested against its neighbourhood only. A cell
/// is at least twice as wide as any vertex is far from its centroid: a sharp tip reaches farther
/// than half the diameter.
class PlacementGrid {
 public:
  explicit PlacementGrid(double cell) : cell_(cell) {}

  [[nodiscard]] bool is_clear(Ring ring, const Vec2& at) const;
  void insert(const ConvexPolygon& polygon, const Vec2& at);

 private:
  [[nodiscard]] long index(double x) const { return std::lround(std::floor(x / cell_)); }
  [[nodiscard]] static std::uint64_t key(long i, long j) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)) << 32) |
           static_cast<std::uint32_t>(j);
  }
  double cell_;
  std::unordered_map<std::uint64_t, std::vector<const ConvexPolygon*>> buckets_;
};

/// Does a ring lie inside a rectangle about the origin?
/// @param half of its width and height [m]
[[nodiscard]] inline bool lies_in_box(Ring ring, const Vec2& half) {
  return std::all_of(ring.begin(), ring.end(), [&half](const Vec2& v) {
    return std::abs(v.x()) < half.x() && std::abs(v.y()) < half.y();
  });
}

/// Is a polygon clear of all that is placed, in the next copies of a periodic cell, too?
[[nodiscard]] bool is_clear_of_images(const PlacementGrid& placed, const ConvexPolygon& polygon,
                                      const Vec2& centre, const Vec2& period);

/// Random places for all polygons, largest first: the small ones find room between the large ones.
/// Throws InvalidInput where there is no room.
/// @param draw_centre() -> a place to try
/// @param is_clear(grid, polygon, centre) -> is it free? The grid holds all particles but platens
template <class DrawCentre, class IsClear>
void place_at_random(const RandomPolygons& made, Assembly& assembly, DrawCentre&& draw_centre,
                     IsClear&& is_clear) {
  std::vector<double> smallness;
  for (const ConvexPolygon& p : made.polygons) smallness.push_back(-area_properties(p.ring()).area);
  const std::size_t first = assembly.particles.size();
  // The grid points into the list, which must not move.
  assembly.particles.reserve(assembly.particles.size() + made.polygons.size());
  PlacementGrid grid(2 * made.farthest);
  for (const PlacedParticle& p : assembly.particles)
    if (p.motion != Motion::platen && p.motion != Motion::wall)
      grid.insert(p.polygon, area_properties(p.polygon.ring()).centroid);

  constexpr unsigned most_tries = 100000;
  for (const std::size_t k : argsort(smallness)) {
    const ConvexPolygon& polygon = made.polygons[k];
    for (unsigned tries = 0;; ++tries) {
      if (tries == most_tries)
        throw InvalidInput("random assembly: no room for particle " +
                           std::to_string(assembly.particles.size()) + " in " +
                           std::to_string(most_tries) + " tries; lower solid_fraction");
      const Vec2 centre = draw_centre();
      ConvexPolygon candidate = polygon.moved({}, centre);
      if (!is_clear(grid, candidate, centre)) continue;
      assembly.particles.push_back({std::move(candidate), Motion::free});
      grid.insert(assembly.particles.back().polygon, centre);
      break;
    }
  }
  sort_by_morton_code(std::span(assembly.particles).subspan(first));
}

}  // namespace riprap::internal

#ifndef RIPRAP_COMPILED
#include <riprap/particle/placement_grid.ipp>
#endif
