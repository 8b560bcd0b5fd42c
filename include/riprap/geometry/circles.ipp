// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <queue>
#include <utility>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/geometry/circles.hpp>
#include <riprap/geometry/line_side.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/geometry/ring_distance.hpp>

namespace riprap {

namespace internal {

/// The points of a convex ring that lie inside all its edges by `depth` [m]: a ring, or none.
[[nodiscard]] inline std::vector<Vec2> inner_ring(Ring ring, double depth) {
  std::vector<Vec2> inner(ring.begin(), ring.end());
  std::vector<Vec2> spare;
  for (std::size_t e = 0; e < ring.size() && !inner.empty(); ++e) {
    const Vec2 edge = ring[next_vertex(e, ring.size())] - ring[e];
    const Vec2 inward = perpendicular(edge) / edge.norm();
    spare.clear();
    for (std::size_t k = 0; k < inner.size(); ++k) {
      const Vec2& from = inner[k];
      const Vec2& to = inner[next_vertex(k, inner.size())];
      const double before = inward.dot(from - ring[e]) - depth;
      const double after = inward.dot(to - ring[e]) - depth;
      if (before >= 0) spare.push_back(from);
      if ((before < 0) != (after < 0))
        spare.push_back(from + before / (before - after) * (to - from));
    }
    std::swap(inner, spare);
  }
  return inner;
}

/// The middle between the two vertices that are farthest apart [m].
[[nodiscard]] inline Vec2 middle_of_diameter(Ring ring) {
  Vec2 middle = ring[0];
  double longest = 0;
  for (const Vec2& p : ring)
    for (const Vec2& q : ring)
      if ((q - p).squaredNorm() > longest) {
        longest = (q - p).squaredNorm();
        middle = p + 0.5 * (q - p);
      }
  return middle;
}

/// The circle through the ends of a diameter.
[[nodiscard]] inline Circle circle_over(const Vec2& p, const Vec2& q) {
  return {p + 0.5 * (q - p), 0.5 * (q - p).norm()};
}

/// The circle through three points that are not on a line.
[[nodiscard]] inline Circle circle_through(const Vec2& p, const Vec2& q, const Vec2& r) {
  const Vec2 a = q - p;
  const Vec2 b = r - p;
  const Vec2 centre = perpendicular(a * b.dot(b) - b * a.dot(a)) / (2 * cross(a, b));
  return {p + centre, centre.norm()};
}

[[nodiscard]] inline bool is_outside(const Circle& circle, const Vec2& v) {
  return (v - circle.centre).norm() > circle.radius * (1 + 1e-14);
}

/// Of a point from the nearest edge of a simple ring [m], negative outside.
[[nodiscard]] inline double depth_inside(const Vec2& x, Ring ring) {
  const double distance = distance_to_ring(x, ring);
  return ring_contains(ring, x) ? distance : -distance;
}

/// A square in which circles may be centred, and a bound on their radii [m].
struct CentreSquare {
  Vec2 centre{0, 0};
  double half_side = 0;
  double bound = 0;

  friend bool operator<(const CentreSquare& a, const CentreSquare& b) { return a.bound < b.bound; }
};

}  // namespace internal

RIPRAP_INLINE Circle inscribed_circle(const ConvexPolygon& polygon) {
  const Ring ring = polygon.ring();
  // The radius by bisection: is there a point so deep inside?
  double possible = 0;
  double impossible = 0.5 * least_width(ring) * (1 + 1e-12);
  while (impossible - possible > 1e-13 * impossible) {
    const double radius = 0.5 * (possible + impossible);
    if (radius <= possible || radius >= impossible) break;
    (internal::inner_ring(ring, radius).empty() ? impossible : possible) = radius;
  }
  // All centres of a slightly smaller circle: a small polygon, or a long thin one.
  const std::vector<Vec2> centres = internal::inner_ring(ring, possible * (1 - 1e-8));
  return {internal::middle_of_diameter(centres), possible};
}

RIPRAP_INLINE Circle inscribed_circle(const Outline& outline, double tolerance) {
  require(tolerance >= 1e-6 && tolerance < 1, "tolerance of the inscribed circle", tolerance,
          "must lie in [1e-6, 1)");
  const Ring ring = outline.ring();
  Vec2 lowest = ring[0];
  Vec2 highest = ring[0];
  for (const Vec2& v : ring) {
    lowest = componentwise_min(lowest, v);
    highest = componentwise_max(highest, v);
  }
  Circle best;
  std::priority_queue<internal::CentreSquare> squares;
  const auto add = [&](const Vec2& centre, double half_side) {
    const double depth = internal::depth_inside(centre, ring);
    if (depth > best.radius) best = {centre, depth};
    squares.push({centre, half_side, depth + std::numbers::sqrt2 * half_side});
  };
  add(lowest + 0.5 * (highest - lowest), 0.5 * (highest - lowest).maxCoeff());
  while (squares.top().bound > best.radius * (1 + tolerance)) {
    const internal::CentreSquare square = squares.top();
    squares.pop();
    const double half = 0.5 * square.half_side;
    for (const double x : {-half, half})
      for (const double y : {-half, half}) add(square.centre + Vec2{x, y}, half);
  }
  return best;
}

RIPRAP_INLINE Circle circumscribed_circle(Ring ring) {
  Circle circle{ring[0], 0};
  for (std::size_t i = 1; i < ring.size(); ++i) {
    if (!internal::is_outside(circle, ring[i])) continue;
    circle = {ring[i], 0};
    for (std::size_t j = 0; j < i; ++j) {
      if (!internal::is_outside(circle, ring[j])) continue;
      circle = internal::circle_over(ring[i], ring[j]);
      for (std::size_t k = 0; k < j; ++k)
        if (internal::is_outside(circle, ring[k]))
          circle = internal::circle_through(ring[i], ring[j], ring[k]);
    }
  }
  return circle;
}

RIPRAP_INLINE Circle least_squares_circle(std::span<const Vec2> points) {
  const auto n = static_cast<double>(points.size());
  Vec2 mean{0, 0};
  for (const Vec2& p : points) mean += p / n;
  // Of x^2 + y^2 - 2 centre . (x, y), about the mean: two normal equations.
  double xx = 0, xy = 0, yy = 0;
  Vec2 right{0, 0};
  for (const Vec2& p : points) {
    const Vec2 d = p - mean;
    xx += d.x() * d.x();
    xy += d.x() * d.y();
    yy += d.y() * d.y();
    right += d * (0.5 * d.dot(d));
  }
  const Vec2 centre =
      Vec2{yy * right.x() - xy * right.y(), xx * right.y() - xy * right.x()} / (xx * yy - xy * xy);
  return {mean + centre, std::sqrt(centre.dot(centre) + (xx + yy) / n)};
}

}  // namespace riprap
