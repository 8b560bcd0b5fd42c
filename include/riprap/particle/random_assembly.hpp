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
  double thickness = 0.016;      ///< [m]; keep it near the diameter, see docs
  std::uint64_t seed = 1;
  PolygonShape shape = {};
  double smallest_diameter = 0.7;  ///< over the mean [-]; diameters are uniform in between
  double largest_diameter = 1.3;   ///< over the mean [-]
  double solid_fraction = 0.45;    ///< before compaction [-]
  double dense_fraction = 0.88;    ///< [-] at which the boundary ring is to be closed

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
    require(dense_fraction > solid_fraction && dense_fraction <= 1,
            "RandomAssembly.dense_fraction", dense_fraction,
            "must lie above solid_fraction and be at most 1");
    shape.validate();
  }
};

namespace internal {

/// Buckets of placed polygons, so that a new one is tested against its neighbourhood only.
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

}  // namespace internal

/// Places polygons at random without overlap inside a circle about the origin. The first ones of
/// the list form the boundary: a ring driven by the strain field, spaced so that it is just closed
/// when the sample has been compacted to `dense_fraction`. Same seed, same bytes.
[[nodiscard]] inline Assembly random_assembly(const RandomAssembly& options) {
  options.validate();
  constexpr double pi = std::numbers::pi;
  Random random(options.seed);
  const double d = options.mean_diameter;
  const auto draw = [&] {
    const double size = d * random.uniform(options.smallest_diameter, options.largest_diameter);
    return random_polygon(options.shape, size, random);
  };

  std::vector<ConvexPolygon> polygons;
  double area = 0;
  for (unsigned i = 0; i < options.count; ++i) {
    polygons.push_back(draw());
    area += area_properties(polygons.back().ring()).area;
  }
  const double dense_radius = std::sqrt(area / (pi * options.dense_fraction));
  const double radius = std::sqrt(area / (pi * options.solid_fraction));

  // The boundary ring: polygons follow each other round the circle, each with the arc it needs.
  double arc = 0;
  std::size_t boundary = 0;
  while (boundary + 1 < polygons.size() && arc < 2 * pi * dense_radius) {
    const Rotation at = Rotation::from_angle(arc / dense_radius);
    arc += internal::tangential_extent(polygons[boundary], Vec2{at.cosine, at.sine});
    ++boundary;
  }
  Assembly assembly{.thickness = options.thickness, .particles = {}};
  const double turn_per_arc = 2 * pi / arc;
  double begun = 0;
  for (std::size_t i = 0; i < boundary; ++i) {
    const Rotation roughly = Rotation::from_angle(begun / dense_radius);
    const double extent =
        internal::tangential_extent(polygons[i], Vec2{roughly.cosine, roughly.sine});
    const Rotation at = Rotation::from_angle(turn_per_arc * (begun + 0.5 * extent));
    assembly.particles.push_back(
        {polygons[i].moved(Rotation{}, radius * Vec2{at.cosine, at.sine}), Motion::strain_field});
    begun += extent;
  }

  // The inside, largest first: the small ones find room between the large ones.
  std::vector<ConvexPolygon> inside(polygons.begin() + static_cast<std::ptrdiff_t>(boundary),
                                    polygons.end());
  std::stable_sort(inside.begin(), inside.end(), [](const auto& a, const auto& b) {
    return area_properties(a.ring()).area > area_properties(b.ring()).area;
  });
  std::vector<ConvexPolygon> placed;
  placed.reserve(options.count);
  double widest = 0;
  for (const ConvexPolygon& p : polygons) widest = std::max(widest, diameter(p.ring()));
  internal::PlacementGrid grid(widest);
  for (const PlacedParticle& p : assembly.particles) {
    placed.push_back(p.polygon);
    grid.insert(placed.back(), area_properties(p.polygon.ring()).centroid);
  }
  constexpr unsigned most_tries = 100000;
  for (const ConvexPolygon& p : inside) {
    unsigned tries = 0;
    for (;; ++tries) {
      if (tries == most_tries)
        throw InvalidInput("RandomAssembly.solid_fraction = " + to_text(options.solid_fraction) +
                           ": no room found for polygon " + std::to_string(placed.size()) +
                           " in " + std::to_string(most_tries) + " tries; choose a lower value");
      const double r = radius * std::sqrt(random.uniform(0, 1));
      const Rotation at = Rotation::from_angle(random.uniform(0, 2 * pi));
      const Vec2 where = r * Vec2{at.cosine, at.sine};
      // Nothing may start outside the ring of boundary centroids.
      if (r > radius - 0.5 * d) continue;
      const ConvexPolygon candidate = p.moved(Rotation{}, where);
      if (!grid.is_clear(candidate.ring(), where)) continue;
      placed.push_back(candidate);
      grid.insert(placed.back(), where);
      assembly.particles.push_back({candidate, Motion::free});
      break;
    }
  }
  return assembly;
}

}  // namespace riprap
