// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Moments of any overlap, and the depth they give with its gradient.

#include <cmath>
#include <cstddef>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/line_side.hpp>
#include <riprap/geometry/overlap.hpp>
#include <riprap/geometry/polygon_properties.hpp>

namespace riprap {

/// The depth of OverlapMoments and its gradient with respect to a rigid motion of body b.
struct PolygonMoments {
  double area = 0;      ///< [m^2]
  Vec2 centroid{0, 0};  ///< [m]
  double depth = 0;     ///< [m]
  Vec2 gradient{0, 0};  ///< minus the rise per displacement of b [-]: the way the force acts on b
  double rotation = 0;  ///< minus the rise per rotation of b about the centroid [m]
};

namespace internal {

/// Unit vector along the longest edge of a polygon.
[[nodiscard]] inline Vec2 longest_direction(const OverlapPolygon& polygon) {
  Vec2 longest{0, 0};
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Vec2 edge = polygon.vertices[i + 1 == polygon.size ? 0 : i + 1] - polygon.vertices[i];
    if (edge.squaredNorm() > longest.squaredNorm()) longest = edge;
  }
  return longest / longest.norm();
}

/// Second moments of a polygon about its centroid, the origin.
struct CentralMoments {
  double uu = 0;
  double vv = 0;
  double uv = 0;

  explicit CentralMoments(Ring ring) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2& p = ring[i];
      const Vec2& q = ring[next_vertex(i, ring.size())];
      const double t = cross(p, q) / 12;
      uu += t * (p.x() * p.x() + p.x() * q.x() + q.x() * q.x());
      vv += t * (p.y() * p.y() + p.y() * q.y() + q.y() * q.y());
      uv += t * (p.x() * p.y() + 0.5 * (p.x() * q.y() + q.x() * p.y()) + q.x() * q.y());
    }
  }
};

}  // namespace internal

/// Of a convex overlap whose edges come from rings a and b. Computed along its longest edge, so
/// that a thin overlap keeps its digits.
[[nodiscard]] inline PolygonMoments polygon_moments(const OverlapPolygon& polygon) {
  PolygonMoments m;
  const AreaProperties properties = area_properties(polygon.ring());
  m.area = properties.area;
  m.centroid = properties.centroid;
  if (!(m.area > 0)) return m;
  const Vec2 axis = internal::longest_direction(polygon);
  const Rotation frame{axis.x(), axis.y()};
  OverlapPolygon placed = polygon;
  for (std::size_t i = 0; i < polygon.size; ++i)
    placed.vertices[i] = frame.inverse_times(polygon.vertices[i] - m.centroid);
  const Ring ring = placed.ring();
  const internal::CentralMoments s(ring);
  const double det = s.uu * s.vv - s.uv * s.uv;
  if (!(det > 0)) return m;
  const double trace = s.uu + s.vv;
  const double unit = 12 / (m.area * trace);
  m.depth = std::sqrt(2 * unit * det);
  // Density of the force; Simpson's rule is exact for it and for its moment.
  const auto density = [&](const Vec2& r) {
    return (s.vv - det / trace) * r.x() * r.x() - 2 * s.uv * r.x() * r.y() +
           (s.uu - det / trace) * r.y() * r.y() - det / m.area;
  };
  Vec2 force{0, 0};
  double moment = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (placed.sources[i].of_b) continue;
    const Vec2& p = ring[i];
    const Vec2& q = ring[next_vertex(i, ring.size())];
    const Vec2 edge = q - p;
    const Vec2 middle = 0.5 * (p + q);
    const double low = density(p);
    const double centre = 4 * density(middle);
    const double high = density(q);
    force += (low + centre + high) * Vec2{edge.y(), -edge.x()};
    moment -= low * p.dot(edge) + centre * middle.dot(edge) + high * q.dot(edge);
  }
  const double factor = unit / (6 * m.depth);
  m.gradient = factor * (frame * force);
  m.rotation = factor * moment;
  return m;
}

}  // namespace riprap
