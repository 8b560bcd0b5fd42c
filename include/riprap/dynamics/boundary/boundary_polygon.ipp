// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include <riprap/dynamics/boundary/boundary_polygon.hpp>
#include <riprap/geometry/ring_distance.hpp>

namespace riprap {

RIPRAP_INLINE Vec2 ring_centre(const Particles& particles) {
  Vec2 mean{0, 0};
  double count = 0;
  const auto for_each_member = [&particles](auto&& visit) {
    for (const Body& body : particles.bodies())
      if (body.motion == Motion::strain_field) visit(body.position);
  };
  for_each_member([&](const Vec2& x) {
    mean += x;
    count += 1;
  });
  if (count == 0) return mean;
  mean = mean / count;
  Stress2 spread;  // second moments
  Vec2 lean{0, 0};
  for_each_member([&](const Vec2& x) {
    const Vec2 d = x - mean;
    spread += symmetric_product(d, d);
    lean += 0.5 * d.dot(d) * d;
  });
  const double determinant = spread.s11 * spread.s22 - spread.s12 * spread.s12;
  if (!(determinant > 0)) return mean;
  const Vec2 centre = mean + Vec2{spread.s22 * lean.x() - spread.s12 * lean.y(),
                                  spread.s11 * lean.y() - spread.s12 * lean.x()} /
                                 determinant;
  const double radius = std::sqrt((spread.s11 + spread.s22) / count);
  const double grid = std::ldexp(1, std::ilogb(radius) - 39);
  return {grid * std::round(centre.x() / grid) + 0.0, grid * std::round(centre.y() / grid) + 0.0};
}

RIPRAP_INLINE BoundaryPolygon::BoundaryPolygon(const Particles& particles)
    : BoundaryPolygon(particles, ring_centre(particles)) {}

RIPRAP_INLINE std::vector<Vec2> BoundaryPolygon::vertices() const {
  std::vector<Vec2> out;
  out.reserve(members_.size());
  for (const BodyIndex i : members_) out.push_back(particles_.body(i).position);
  return out;
}

RIPRAP_INLINE Vec2 BoundaryPolygon::semi_axes() const {
  Vec2 widest{0, 0};
  for (const BodyIndex i : members_)
    widest = componentwise_max(widest, componentwise_abs(particles_.body(i).position - centre_));
  return widest;
}

RIPRAP_INLINE double BoundaryPolygon::solid_area() const {
  double sum = rock_area(particles_);
  const std::vector<Vec2> ring = vertices();
  const std::size_t n = ring.size();
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t next = (k + 1) % n;
    const Ring here = particles_.ring(members_[k]);
    sum += area_in_wedge(here, ring[k] - ring[(k + n - 1) % n], ring[next] - ring[k], ring[k]);
    const OverlapPolygon common = overlap(here, particles_.ring(members_[next]), Vec2{0, 0}, 0);
    sum -= area_on_left(common.ring(), Line{ring[k], (ring[next] - ring[k]).normalized()});
  }
  return sum;
}

RIPRAP_INLINE std::size_t BoundaryPolygon::lost() const {
  const std::vector<Vec2> ring = vertices();
  std::size_t count = 0;
  for (const Body& body : particles_.bodies())
    count += body.is_free() && !ring_contains(ring, body.position);
  return count;
}

RIPRAP_INLINE std::vector<Vec2> BoundaryPolygon::part_on_left(Ring ring, const Line& line) {
  if (ring.empty()) return {};
  if (const auto parts = internal::divide(ring, line, 1e-6 * diameter(ring))) return parts->left;
  if (line.left_distance(area_properties(ring).centroid) < 0) return {};
  return {ring.begin(), ring.end()};
}

RIPRAP_INLINE double BoundaryPolygon::area_in_wedge(Ring ring, const Vec2& side_in,
                                                    const Vec2& side_out, const Vec2& corner) {
  const bool reflex = cross(side_in, side_out) < 0;
  const double sign = reflex ? -1 : 1;
  // At a reflex corner the part outside is the one that two half-planes bound.
  const std::vector<Vec2> half = part_on_left(ring, {corner, sign * side_in.normalized()});
  const double bounded = area_on_left(half, {corner, sign * side_out.normalized()});
  return reflex ? area_properties(ring).area - bounded : bounded;
}

}  // namespace riprap
