// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Moments of any overlap, and the depth they give with its gradient.

#include <cmath>
#include <cstddef>

#include <riprap/contact/pair/contact_geometry.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/geometry/overlap.hpp>

namespace riprap {

/// The depth of OverlapMoments and its gradient with respect to a rigid motion of body b.
struct PolygonMoments {
  double area = 0;      ///< [m^2]
  Vec2 centroid{0, 0};  ///< [m]
  double depth = 0;     ///< [m]
  Vec2 gradient{0, 0};  ///< minus the rise per displacement of b [-]: the way the force acts on b
  double rotation = 0;  ///< minus the rise per rotation of b about the centroid [m]
};

/// Of a convex overlap whose edges come from rings a and b.
[[nodiscard]] inline PolygonMoments polygon_moments(const OverlapPolygon& polygon) {
  PolygonMoments m;
  const auto next = [&](std::size_t i) { return i + 1 == polygon.size ? 0 : i + 1; };
  const Vec2 origin = polygon.vertices[0];
  double twice_area = 0;
  Vec2 first{0, 0};
  for (std::size_t i = 1; i + 1 < polygon.size; ++i) {
    const Vec2 p = polygon.vertices[i] - origin;
    const Vec2 q = polygon.vertices[i + 1] - origin;
    const double t = cross(p, q);
    twice_area += t;
    first += t * (p + q);
  }
  m.area = 0.5 * twice_area;
  if (!(m.area > 0)) return m;
  m.centroid = origin + first / (3 * twice_area);
  // Covariance about the centroid times the area.
  double xx = 0;
  double yy = 0;
  double xy = 0;
  for (std::size_t i = 0; i < polygon.size; ++i) {
    const Vec2 p = polygon.vertices[i] - m.centroid;
    const Vec2 q = polygon.vertices[next(i)] - m.centroid;
    const double t = cross(p, q) / 12;
    xx += t * (p.x() * p.x() + p.x() * q.x() + q.x() * q.x());
    yy += t * (p.y() * p.y() + p.y() * q.y() + q.y() * q.y());
    xy += t * (p.x() * p.y() + 0.5 * (p.x() * q.y() + q.x() * p.y()) + q.x() * q.y());
  }
  const double det = xx * yy - xy * xy;
  if (!(det > 0)) return m;
  const double trace = xx + yy;
  const double unit = 12 / (m.area * trace);
  m.depth = std::sqrt(2 * unit * det);
  // Density of the force; Simpson's rule is exact for it and for its moment.
  const auto density = [&](const Vec2& r) {
    return yy * r.x() * r.x() - 2 * xy * r.x() * r.y() + xx * r.y() * r.y() - det / m.area -
           det / trace * r.squaredNorm();
  };
  for (std::size_t i = 0; i < polygon.size; ++i) {
    if (polygon.sources[i].of_b) continue;
    const Vec2 p = polygon.vertices[i] - m.centroid;
    const Vec2 q = polygon.vertices[next(i)] - m.centroid;
    const Vec2 edge = q - p;
    const Vec2 middle = 0.5 * (p + q);
    const double low = density(p);
    const double centre = 4 * density(middle);
    const double high = density(q);
    m.gradient += (low + centre + high) * Vec2{edge.y(), -edge.x()};
    m.rotation -= low * p.dot(edge) + centre * middle.dot(edge) + high * q.dot(edge);
  }
  const double factor = unit / (6 * m.depth);
  m.gradient *= factor;
  m.rotation *= factor;
  return m;
}

}  // namespace riprap
