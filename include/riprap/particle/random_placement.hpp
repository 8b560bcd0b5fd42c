// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Random polygons at random places, without overlap: what all random assemblies share.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <riprap/core/argsort.hpp>
#include <riprap/core/random.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <riprap/geometry/separation.hpp>
#include <riprap/particle/assembly.hpp>
#include <riprap/particle/spatial_order.hpp>

namespace riprap {

/// What a random assembly is made of.
struct RandomAssembly {
  /// Particles. Those of the ring are among them (random_assembly); platens come on top
  /// (random_platen_assembly); a periodic cell has no others (random_periodic_assembly).
  unsigned count = 500;
  double mean_diameter = 0.016;  ///< of the circle of equal area [m]; see `diameters`
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
  /// Diameters of the circles of equal area [m], one for each particle, in any order: they are
  /// shuffled. Their mean takes the place of mean_diameter. Empty: drawn from the range above.
  std::vector<double> diameters = {};
  /// Outlines to choose from at random, turned at random and scaled to the diameters; their own
  /// size and place do not count. Empty: random polygons of `shape`.
  std::vector<ConvexPolygon> outlines = {};

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
    require(diameters.empty() || diameters.size() == count, "RandomAssembly.diameters.size()",
            static_cast<double>(diameters.size()), "must be 0 or RandomAssembly.count");
    for (const double d : diameters) require_positive("RandomAssembly.diameters", d);
    shape.validate();
  }
};

namespace internal {

/// Random polygons that are to be placed.
struct RandomPolygons {
  std::vector<ConvexPolygon> polygons;  ///< about their own centroids
  double area = 0;                      ///< of all [m^2]
  double farthest = 0;                  ///< vertex from its centroid [m]
};

[[nodiscard]] inline double mean_diameter(const RandomAssembly& options) {
  if (options.diameters.empty()) return options.mean_diameter;
  double sum = 0;
  for (const double d : options.diameters) sum += d;
  return sum / static_cast<double>(options.diameters.size());
}

/// The diameters of the options in random order (Fisher and Yates). Draws nothing if there are
/// none.
[[nodiscard]] inline std::vector<double> shuffled_diameters(const RandomAssembly& options,
                                                            Random& random) {
  std::vector<double> diameters = options.diameters;
  for (std::size_t i = diameters.size(); i > 1; --i)
    std::swap(diameters[i - 1], diameters[random.uniform_integer(0, static_cast<unsigned>(i - 1))]);
  return diameters;
}

/// One of the outlines, turned, with its centroid at the origin and the area of a circle of the
/// given diameter [m].
[[nodiscard]] inline ConvexPolygon random_outline(const std::vector<ConvexPolygon>& outlines,
                                                  double equivalent_diameter, Random& random) {
  const auto last = static_cast<unsigned>(outlines.size() - 1);
  const ConvexPolygon& outline = outlines[random.uniform_integer(0, last)];
  const Rotation turn = Rotation::from_angle(random.uniform(0, 2 * std::numbers::pi));
  const AreaProperties own = area_properties(outline.ring());
  const double scale = equivalent_diameter / riprap::equivalent_diameter(own.area);
  std::vector<Vec2> vertices;
  for (const Vec2& v : outline) vertices.push_back(scale * (turn * (v - own.centroid)));
  return ConvexPolygon(std::move(vertices));
}

[[nodiscard]] inline RandomPolygons random_polygons(const RandomAssembly& options, Random& random) {
  RandomPolygons made;
  const std::vector<double> diameters = shuffled_diameters(options, random);
  for (unsigned i = 0; i < options.count; ++i) {
    const double size = diameters.empty()
                            ? options.mean_diameter * random.uniform(options.smallest_diameter,
                                                                     options.largest_diameter)
                            : diameters[i];
    made.polygons.push_back(options.outlines.empty()
                                ? random_polygon(options.shape, size, random)
                                : random_outline(options.outlines, size, random));
    made.area += area_properties(made.polygons.back().ring()).area;
    for (const Vec2& v : made.polygons.back()) made.farthest = std::max(made.farthest, v.norm());
  }
  return made;
}

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
    if (p.motion != Motion::platen)
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

}  // namespace internal
}  // namespace riprap
