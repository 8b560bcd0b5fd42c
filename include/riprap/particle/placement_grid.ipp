// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <numbers>
#include <utility>

#include <riprap/geometry/separation.hpp>
#include <riprap/particle/placement_grid.hpp>

namespace riprap::internal {

RIPRAP_INLINE double mean_diameter(const RandomAssembly& options) {
  if (options.diameters.empty()) return options.mean_diameter;
  double sum = 0;
  for (const double d : options.diameters) sum += d;
  return sum / static_cast<double>(options.diameters.size());
}

/// The diameters of the options in random order (Fisher and Yates). Draws nothing if there are
/// none.
[[nodiscard]] RIPRAP_INLINE std::vector<double> shuffled_diameters(const RandomAssembly& options,
                                                                   Random& random) {
  std::vector<double> diameters = options.diameters;
  for (std::size_t i = diameters.size(); i > 1; --i)
    std::swap(diameters[i - 1], diameters[random.uniform_integer(0, static_cast<unsigned>(i - 1))]);
  return diameters;
}

/// One of the outlines, turned, with its centroid at the origin and the area of a circle of the
/// given diameter [m].
[[nodiscard]] RIPRAP_INLINE ConvexPolygon random_outline(const std::vector<ConvexPolygon>& outlines,
                                                         double equivalent_diameter,
                                                         Random& random) {
  const auto last = static_cast<unsigned>(outlines.size() - 1);
  const ConvexPolygon& outline = outlines[random.uniform_integer(0, last)];
  const Rotation turn = Rotation::from_angle(random.uniform(0, 2 * std::numbers::pi));
  const AreaProperties own = area_properties(outline.ring());
  const double scale = equivalent_diameter / riprap::equivalent_diameter(own.area);
  std::vector<Vec2> vertices;
  for (const Vec2& v : outline) vertices.push_back(scale * (turn * (v - own.centroid)));
  return ConvexPolygon(std::move(vertices));
}

/// The next diameter of the range of the options [m].
[[nodiscard]] RIPRAP_INLINE double drawn_diameter(const RandomAssembly& options, Random& random) {
  return options.mean_diameter *
         random.uniform(options.smallest_diameter, options.largest_diameter);
}

RIPRAP_INLINE std::vector<double> random_diameters(const RandomAssembly& options, Random& random) {
  std::vector<double> diameters = shuffled_diameters(options, random);
  while (diameters.size() < options.count) diameters.push_back(drawn_diameter(options, random));
  return diameters;
}

/// The next polygon of the options, of this diameter [m].
[[nodiscard]] RIPRAP_INLINE ConvexPolygon next_polygon(const RandomAssembly& options, double size,
                                                       Random& random) {
  if (!options.outlines.empty()) return random_outline(options.outlines, size, random);
  if (options.prescribed_shape) return random_polygon(*options.prescribed_shape, size, random);
  return random_polygon(options.shape, size, random);
}

RIPRAP_INLINE RandomPolygons random_polygons(const RandomAssembly& options, Random& random) {
  RandomPolygons made;
  const std::vector<double> diameters = shuffled_diameters(options, random);
  for (unsigned i = 0; i < options.count; ++i) {
    const double size = diameters.empty() ? drawn_diameter(options, random) : diameters[i];
    made.polygons.push_back(next_polygon(options, size, random));
    made.area += area_properties(made.polygons.back().ring()).area;
    for (const Vec2& v : made.polygons.back()) made.farthest = std::max(made.farthest, v.norm());
  }
  return made;
}

RIPRAP_INLINE bool PlacementGrid::is_clear(Ring ring, const Vec2& at) const {
  for (long i = index(at.x()) - 1; i <= index(at.x()) + 1; ++i)
    for (long j = index(at.y()) - 1; j <= index(at.y()) + 1; ++j) {
      const auto found = buckets_.find(key(i, j));
      if (found == buckets_.end()) continue;
      for (const ConvexPolygon* other : found->second) {
        SeparatingEdge memory;
        if (!separated(ring, other->ring(), memory)) return false;
      }
    }
  return true;
}

RIPRAP_INLINE bool is_clear_of_images(const PlacementGrid& placed, const ConvexPolygon& polygon,
                                      const Vec2& centre, const Vec2& period) {
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j) {
      const Vec2 offset{i * period.x(), j * period.y()};
      if (!placed.is_clear(polygon.moved({}, offset).ring(), centre + offset)) return false;
    }
  return true;
}

RIPRAP_INLINE void PlacementGrid::insert(const ConvexPolygon& polygon, const Vec2& at) {
  buckets_[key(index(at.x()), index(at.y()))].push_back(&polygon);
}

}  // namespace riprap::internal
