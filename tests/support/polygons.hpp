// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Polygons whose properties have a closed form, and the poses to look at them in.

#include <cstddef>
#include <numbers>
#include <vector>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/convex_polygon.hpp>

namespace riprap::test {

inline constexpr double pi = std::numbers::pi;

/// [0, 1] x [0, 1]; edges 0 to 3 are bottom, right, top, left.
[[nodiscard]] inline ConvexPolygon unit_square() { return {{0, 0}, {1, 0}, {1, 1}, {0, 1}}; }

/// Rectangle about the origin.
[[nodiscard]] inline ConvexPolygon rectangle(double width, double height) {
  const double x = 0.5 * width;
  const double y = 0.5 * height;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

/// n vertices on a circle about the origin, the first at angle `start` [rad].
[[nodiscard]] inline ConvexPolygon regular_polygon(std::size_t n, double circumradius,
                                                   double start = 0) {
  std::vector<Vec2> vertices;
  for (std::size_t i = 0; i < n; ++i) {
    const double angle = start + 2 * pi * static_cast<double>(i) / static_cast<double>(n);
    vertices.push_back(circumradius * (Rotation::from_angle(angle) * Vec2{1, 0}));
  }
  return ConvexPolygon(std::move(vertices));
}

[[nodiscard]] inline ConvexPolygon shifted(const ConvexPolygon& polygon, const Vec2& shift) {
  return polygon.moved({}, shift);
}

/// The mirror image in axis 2, counter-clockwise again.
[[nodiscard]] inline ConvexPolygon mirrored(const ConvexPolygon& polygon) {
  std::vector<Vec2> vertices;
  for (std::size_t i = polygon.size(); i-- > 0;)
    vertices.push_back({-polygon[i].x(), polygon[i].y()});
  return ConvexPolygon(std::move(vertices));
}

/// The same ring begun at another vertex.
[[nodiscard]] inline ConvexPolygon begun_at(const ConvexPolygon& polygon, std::size_t first) {
  std::vector<Vec2> vertices;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    vertices.push_back(polygon[(first + i) % polygon.size()]);
  return ConvexPolygon(std::move(vertices));
}

/// The same polygon in other units of length.
[[nodiscard]] inline ConvexPolygon scaled(const ConvexPolygon& polygon, double factor) {
  std::vector<Vec2> vertices;
  for (const Vec2& v : polygon) vertices.push_back(factor * v);
  return ConvexPolygon(std::move(vertices));
}

/// A rigid motion under which statements about shapes hold as before.
struct Pose {
  Rotation rotation;
  Vec2 shift{0, 0};
  double digits = 1;  ///< round-off of coordinates grows by this factor

  [[nodiscard]] ConvexPolygon of(const ConvexPolygon& polygon) const {
    return polygon.moved(rotation, shift);
  }
  [[nodiscard]] Vec2 of(const Vec2& point) const { return rotation * point + shift; }
};

/// As it is, turned by an odd angle, and a thousand sizes away from the origin besides.
[[nodiscard]] inline std::vector<Pose> poses(double size) {
  return {{{}, {0, 0}, 1},
          {Rotation::from_angle(0.7345), {0, 0}, 1},
          {Rotation::from_angle(-2.2), {800 * size, -600 * size}, 1000}};
}

}  // namespace riprap::test
