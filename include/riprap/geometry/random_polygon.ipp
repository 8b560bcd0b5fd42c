// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include <riprap/geometry/random_polygon.hpp>

namespace riprap {

RIPRAP_INLINE void PolygonShape::validate() const {
  require(fewest_vertices >= 3, "PolygonShape.fewest_vertices", fewest_vertices,
          "must be 3 or more");
  require(most_vertices >= fewest_vertices && most_vertices <= max_polygon_vertices,
          "PolygonShape.most_vertices", most_vertices, "must lie between fewest_vertices and 64");
  require(smallest_axis_ratio > 0 && smallest_axis_ratio <= 1, "PolygonShape.smallest_axis_ratio",
          smallest_axis_ratio, "must lie in (0, 1]");
  require(largest_axis_ratio >= smallest_axis_ratio && largest_axis_ratio <= 1,
          "PolygonShape.largest_axis_ratio", largest_axis_ratio,
          "must lie between smallest_axis_ratio and 1");
  require(angle_jitter >= 0 && angle_jitter < 1, "PolygonShape.angle_jitter", angle_jitter,
          "must lie in [0, 1)");
}

RIPRAP_INLINE ConvexPolygon random_polygon(const PolygonShape& shape, double equivalent_diameter,
                                           Random& random) {
  constexpr double two_pi = 2 * std::numbers::pi;
  const unsigned n = random.uniform_integer(shape.fewest_vertices, shape.most_vertices);
  const double ratio = random.uniform(shape.smallest_axis_ratio, shape.largest_axis_ratio);
  const Rotation orientation = Rotation::from_angle(random.uniform(0, two_pi));
  const double start = random.uniform(0, two_pi);
  std::vector<Vec2> vertices;
  for (unsigned i = 0; i < n; ++i) {
    const double jitter = shape.angle_jitter * random.uniform(-0.5, 0.5);
    const Rotation at = Rotation::from_angle(start + two_pi * (i + jitter) / n);
    vertices.push_back(orientation * Vec2{at.cosine, ratio * at.sine});
  }
  const AreaProperties raw = area_properties(vertices);
  const double area = 0.25 * std::numbers::pi * equivalent_diameter * equivalent_diameter;
  const double scale = std::sqrt(area / raw.area);
  for (Vec2& v : vertices) v = scale * (v - raw.centroid);
  return ConvexPolygon(std::move(vertices));
}

}  // namespace riprap
