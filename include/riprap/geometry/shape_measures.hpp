// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Measures of the shape of a particle: numbers without a unit that size, place and rotation do not
/// change. Optional: not part of riprap.hpp.
///
/// `aspect` of polygon_properties.hpp, the largest Feret diameter over the least, is one of them.
/// Wadell's roundness, of digitised outlines, is in wadell_roundness.hpp.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/bounding_rectangle.hpp>
#include <riprap/geometry/circles.hpp>
#include <riprap/geometry/convex_hull.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/geometry/line_side.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/geometry/second_moments.hpp>

namespace riprap {

/// The longer over the shorter side of the rectangle of least area around a ring [-], 1 or more.
[[nodiscard]] inline double elongation(Ring ring) {
  const BoundingRectangle box = least_area_rectangle(ring);
  return box.length / box.width;
}

/// Root of the ratio of the principal second moments of area [-], 1 or more: the ratio of the axes
/// of the ellipse, or of the sides of the rectangle, with the same ratio of moments. Of a simple
/// counter-clockwise ring.
[[nodiscard]] inline double moment_elongation(Ring ring) {
  const SecondMoments m = second_moments(ring, area_properties(ring).centroid);
  const double mean = 0.5 * (m.xx + m.yy);
  const double radius = std::hypot(0.5 * (m.xx - m.yy), m.xy);
  return std::sqrt((mean + radius) / (mean - radius));
}

/// 4 pi area / perimeter^2 [-], 1 of a circle (E. P. Cox: A method of assigning numerical and
/// percentage values to the degree of roundness of sand grains, J. Paleontol. 1, 1927). Of a simple
/// counter-clockwise ring.
[[nodiscard]] inline double circularity(Ring ring) {
  const double length = perimeter(ring);
  return 4 * std::numbers::pi * polygon_area(ring) / (length * length);
}

/// Radius of the largest circle inside over that of the smallest around [-], 1 of a circle (J. C.
/// Santamarina, G. C. Cho: Soil behaviour: the role of particle shape, Skempton Conf. 2004). The
/// sphericity of N. A. Riley (J. Sediment. Petrol. 11, 1941) is its root.
[[nodiscard]] inline double sphericity(const ConvexPolygon& polygon) {
  return inscribed_circle(polygon).radius / circumscribed_circle(polygon.ring()).radius;
}

/// Area over that of the convex hull [-], 1 of a convex ring; also called solidity (ISO 9276-6). Of
/// a simple counter-clockwise ring.
[[nodiscard]] inline double convexity(Ring ring) {
  return polygon_area(ring) / polygon_area(convex_hull(ring));
}

/// Degree of angularity [rad]: the sum over the corners of (pi - alpha) x / r, where alpha is the
/// angle of the corner, x the distance of its tip from the centre of the largest circle inside and
/// r the radius of that (G. Lees: A new method for determining the angularity of particles,
/// Sedimentology 3, 1964, in degrees there). 4 pi (720 degrees) of an equilateral triangle, 2 pi /
/// cos(pi / n) of a regular polygon, more of a slender or a sharp one.
[[nodiscard]] inline double angularity(const ConvexPolygon& polygon) {
  const Circle inside = inscribed_circle(polygon);
  const std::size_t n = polygon.size();
  double sum = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 before = polygon[k] - polygon[previous_vertex(k, n)];
    const Vec2 after = polygon[next_vertex(k, n)] - polygon[k];
    const double turn = std::atan2(cross(before, after), before.dot(after));
    sum += turn * (polygon[k] - inside.centre).norm() / inside.radius;
  }
  return sum;
}

}  // namespace riprap
