// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

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

/// A circle about the origin on which the ring closes when dense, and the one on which it is
/// placed.
struct CircularRing {
  double dense_radius;  // [m]
  double radius;        // [m]

  [[nodiscard]] double dense_length() const { return 2 * std::numbers::pi * dense_radius; }
  /// Outward normal at an arc length of the dense circle.
  [[nodiscard]] Vec2 normal(double arc) const {
    const Rotation at = Rotation::from_angle(arc / dense_radius);
    return {at.cosine, at.sine};
  }
  /// Point [m] at `arc` of `length` round the circle.
  [[nodiscard]] Vec2 point(double arc, double length) const {
    const Rotation at = Rotation::from_angle(2 * std::numbers::pi * arc / length);
    return radius * Vec2{at.cosine, at.sine};
  }
  /// Uniform inside, at least `margin` from the circle [m].
  [[nodiscard]] Vec2 inside(double margin, Random& random) const {
    const double r = (radius - margin) * std::sqrt(random.uniform(0, 1));
    const Rotation at = Rotation::from_angle(random.uniform(0, 2 * std::numbers::pi));
    return r * Vec2{at.cosine, at.sine};
  }
};

/// The same of a rectangle about the origin, counterclockwise from its lower right corner.
struct RectangularRing {
  Vec2 dense_half;  // half of its width and height [m]
  Vec2 half;        // [m]

  [[nodiscard]] double dense_length() const { return 4 * (dense_half.x() + dense_half.y()); }
  [[nodiscard]] Vec2 normal(double arc) const {
    const int side = on_side(dense_half, arc).first;
    return side % 2 == 0 ? Vec2{1.0 - side, 0} : Vec2{0, 2.0 - side};
  }
  [[nodiscard]] Vec2 point(double arc, double length) const {
    const auto [side, along] = on_side(half, 4 * (half.x() + half.y()) * arc / length);
    switch (side) {
    case 0:
      return {half.x(), along - half.y()};
    case 1:
      return {half.x() - along, half.y()};
    case 2:
      return {-half.x(), half.y() - along};
    default:
      return {along - half.x(), -half.y()};
    }
  }
  [[nodiscard]] Vec2 inside(double margin, Random& random) const {
    return place_in_box(half - Vec2{margin, margin}, random);
  }

 private:
  // Number of the side at an arc length, from 0 for the right one to 3 for the bottom, and the
  // length along it.
  [[nodiscard]] static std::pair<int, double> on_side(const Vec2& half, double arc) {
    int side = 0;
    for (; side < 3; ++side) {
      const double length = 2 * (side % 2 == 0 ? half.y() : half.x());
      if (arc < length) break;
      arc -= length;
    }
    return {side, arc};
  }
};

/// Polygons one after the other round the outline, each with the arc it needs. Moves the first few
/// of `polygons` into the assembly.
template <class Outline>
void place_ring(std::vector<ConvexPolygon>& polygons, const Outline& outline, double spacing,
                Assembly& assembly) {
  std::vector<double> arcs;
  double length = 0;
  while (arcs.size() + 1 < polygons.size() && length < outline.dense_length()) {
    arcs.push_back(spacing * tangential_extent(polygons[arcs.size()], outline.normal(length)));
    length += arcs.back();
  }
  double begun = 0;
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const Vec2 centre = outline.point(begun + 0.5 * arcs[i], length);
    assembly.particles.push_back({polygons[i].moved({}, centre), Motion::strain_field});
    begun += arcs[i];
  }
  polygons.erase(polygons.begin(), polygons.begin() + static_cast<std::ptrdiff_t>(arcs.size()));
}

/// The ring, and all other polygons at random inside it.
template <class Outline>
[[nodiscard]] Assembly fill_ring(const RandomAssembly& options, const Outline& outline,
                                 RandomPolygons& random_ones, Random& random) {
  Assembly assembly{.thickness = options.thickness, .particles = {}};
  place_ring(random_ones.polygons, outline, options.boundary_spacing, assembly);
  // Nothing may start outside the ring of boundary centroids.
  const double margin = 0.5 * mean_diameter(options);
  place_at_random(
      random_ones, assembly, [&] { return outline.inside(margin, random); },
      [](const PlacementGrid& placed, const ConvexPolygon& candidate, const Vec2& centre) {
        return placed.is_clear(candidate.ring(), centre);
      });
  return assembly;
}

}  // namespace internal

RIPRAP_INLINE Assembly random_assembly(const RandomAssembly& options) {
  options.validate();
  Random random(options.seed);
  internal::RandomPolygons made = internal::random_polygons(options, random);
  if (options.sample_outline == SampleOutline::rectangle) {
    const internal::RectangularRing ring{
        internal::half_extents(made.area / options.dense_fraction, options.aspect_ratio),
        internal::half_extents(made.area / options.solid_fraction, options.aspect_ratio)};
    return internal::fill_ring(options, ring, made, random);
  }
  require(options.aspect_ratio == 1, "RandomAssembly.aspect_ratio", options.aspect_ratio,
          "must be 1 for a circle");
  const internal::CircularRing ring{
      std::sqrt(made.area / (std::numbers::pi * options.dense_fraction)),
      std::sqrt(made.area / (std::numbers::pi * options.solid_fraction))};
  return internal::fill_ring(options, ring, made, random);
}

}  // namespace riprap
