// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <riprap/geometry/separation.hpp>
#include <riprap/particle/placement_grid.hpp>

namespace riprap::internal {

RIPRAP_INLINE RandomPolygons random_polygons(const RandomAssembly& options, Random& random) {
  RandomPolygons made;
  for (unsigned i = 0; i < options.count; ++i) {
    const double size =
        options.mean_diameter * random.uniform(options.smallest_diameter, options.largest_diameter);
    made.polygons.push_back(random_polygon(options.shape, size, random));
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

RIPRAP_INLINE void PlacementGrid::insert(const ConvexPolygon& polygon, const Vec2& at) {
  buckets_[key(index(at.x()), index(at.y()))].push_back(&polygon);
}

}  // namespace riprap::internal
