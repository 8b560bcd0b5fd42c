#pragma once
/// @file
/// A loose circular assembly of random sharp polygons inside a ring of boundary particles.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <unordered_map>
#include <vector>

#include <riprap/core/random.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <riprap/geometry/separation.hpp>
#include <riprap/particle/assembly.hpp>

namespace riprap {

/// What a random assembly is made of.
struct RandomAssembly {
  unsigned count = 500;          ///< particles, those of the boundary included
  double mean_diameter = 0.016;  ///< of the circle of equal area [m]
  double thickness = 0.016;      ///< [m]; keep it near the diameter, see docs/choices.md
  std::uint64_t seed = 1;
  PolygonShape shape = {};
  double smallest_diameter = 0.7;  ///< over the mean [-]; diameters are uniform in between
  double largest_diameter = 1.3;   ///< over the mean [-]
  double solid_fraction = 0.45;    ///< before compaction [-]
  double dense_fraction = 0.88;    ///< expected after compaction [-]; sets the boundary's count
  /// Distance along the ring, when dense, over the particles' extent [-]. Boundary particles do not
  /// touch each other; below 1 the ring stays closed when shear stretches it.
  double boundary_spacing = 0.8;

  /// Throws InvalidInput that names the value and the rule.
  void validate() const {
    require(count >= 30, "RandomAssembly.count", count, "must be 30 or more");
    require_positive("RandomAssembly.mean_diameter", mean_diameter);
    require_positive("RandomAssembly.thickness", thickness);
    require(smallest_diameter > 0 && smallest_diameter <= 1, "RandomAssembly.smallest_diameter",
            smallest_diameter, "must lie in (0, 1]");
    require(largest_diameter >= 1 && largest_diameter <= 10, "RandomAssembly.largest_diameter",
            largest_diameter, "must lie in [1, 10]");
    require(solid_fraction >= 0.05 && solid_fraction <= 0.5, "RandomAssembly.solid_fraction",
            solid_fraction, "must lie in [0.05, 0.5] (random placement jams above)");
    require(dense_fraction > solid_fraction && dense_fraction <= 1, "RandomAssembly.dense_fraction",
            dense_fraction, "must lie above solid_fraction and be at most 1");
    require(boundary_spacing > 0 && boundary_spacing <= 2, "RandomAssembly.boundary_spacing",
            boundary_spacing, "must lie in (0, 2]");
    shape.validate();
  }
};

namespace internal {

/// Buckets of placed polygons, so that a new one is tested against its neighbourhood only. A cell
/// is at least twice as wide as any vertex is far from its centroid: a sharp tip reaches farther
/// than half the diameter.
class PlacementGrid {
 public:
  explicit PlacementGrid(double cell) : cell_(cell) {}

  [[nodiscard]] bool is_clear(Ring ring, const Vec2& at) const {
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
  void insert(const ConvexPolygon& polygon, const Vec2& at) {
    buckets_[key(index(at.x()), index(at.y()))].push_back(&polygon);
  }

 private:
  [[nodiscard]] long index(double x) const { return std::lround(std::floor(x / cell_)); }
  [[nodiscard]] static std::uint64_t key(long i, long j) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)) << 32) |
           static_cast<std::uint32_t>(j);
  }
  double cell_;
  std::unordered_map<std::uint64_t, std::vector<const ConvexPolygon*>> buckets_;
};

/// Extent of a polygon across the direction from the origin to `at`.
[[nodiscard]] inline double tangential_extent(const ConvexPolygon& polygon, const Vec2& at) {
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
inline void place_ring(std::vector<ConvexPolygon>& polygons, double dense_radius, double radius,
                       double spacing, Assembly& assembly) {
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

/// Random places within `reach` of the origin for all polygons, largest first: the small ones find
/// room between the large ones. Throws InvalidInput where there is no room.
inline void place_inside(std::vector<ConvexPolygon>& polygons, double reach, double cell,
                         Random& random, Assembly& assembly) {
  std::stable_sort(polygons.begin(), polygons.end(), [](const auto& a, const auto& b) {
    return area_properties(a.ring()).area > area_properties(b.ring()).area;
  });
  // The grid points into the list, which must not move.
  assembly.particles.reserve(assembly.particles.size() + polygons.size());
  PlacementGrid grid(cell);
  for (const PlacedParticle& p : assembly.particles)
    grid.insert(p.polygon, area_properties(p.polygon.ring()).centroid);

  constexpr unsigned most_tries = 100000;
  for (const ConvexPolygon& polygon : polygons) {
    for (unsigned tries = 0;; ++tries) {
      if (tries == most_tries)
        throw InvalidInput("random assembly: no room for particle " +
                           std::to_string(assembly.particles.size()) + " in " +
                           std::to_string(most_tries) + " tries; lower solid_fraction");
      const double r = reach * std::sqrt(random.uniform(0, 1));
      const Rotation at = Rotation::from_angle(random.uniform(0, 2 * std::numbers::pi));
      const Vec2 centre = r * Vec2{at.cosine, at.sine};
      ConvexPolygon candidate = polygon.moved({}, centre);
      if (!grid.is_clear(candidate.ring(), centre)) continue;
      assembly.particles.push_back({std::move(candidate), Motion::free});
      grid.insert(assembly.particles.back().polygon, centre);
      break;
    }
  }
}

}  // namespace internal

/// Places polygons at random without overlap inside a circle about the origin. The first ones of
/// the list form the boundary: a ring driven by the strain field. Same seed, same bytes.
[[nodiscard]] inline Assembly random_assembly(const RandomAssembly& options) {
  options.validate();
  Random random(options.seed);
  const double d = options.mean_diameter;
  std::vector<ConvexPolygon> polygons;
  double area = 0;
  double farthest = 0;
  for (unsigned i = 0; i < options.count; ++i) {
    const double size = d * random.uniform(options.smallest_diameter, options.largest_diameter);
    polygons.push_back(random_polygon(options.shape, size, random));
    area += area_properties(polygons.back().ring()).area;
    for (const Vec2& v : polygons.back()) farthest = std::max(farthest, v.norm());
  }
  const double dense_radius = std::sqrt(area / (std::numbers::pi * options.dense_fraction));
  const double radius = std::sqrt(area / (std::numbers::pi * options.solid_fraction));

  Assembly assembly{.thickness = options.thickness, .particles = {}};
  internal::place_ring(polygons, dense_radius, radius, options.boundary_spacing, assembly);
  // Nothing may start outside the ring of boundary centroids.
  internal::place_inside(polygons, radius - 0.5 * d, 2 * farthest, random, assembly);
  return assembly;
}

}  // namespace riprap
