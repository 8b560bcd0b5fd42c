#pragma once
/// @file
/// How the vertices of one convex ring lie to one edge of another.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include <riprap/core/vec2.hpp>
#include <riprap/geometry/convex_polygon.hpp>

namespace riprap {

/// Distances of a ring's vertices from the line of an edge, inwards.
struct EdgeSide {
  /// Times the length of the edge [m^2]; as many as there are vertices.
  std::array<double, max_polygon_vertices> distances;
  double deepest = 0;       ///< greatest of them
  std::size_t inside = 0;   ///< how many are not negative ...
  std::uint64_t which = 0;  ///< ... and which: vertex k is bit k

  /// Of the deepest vertex below edge `i` of `ring` [m]; negative: so far apart are the two.
  [[nodiscard]] double depth(Ring ring, std::size_t i) const {
    const Vec2 edge = ring[i + 1 == ring.size() ? 0 : i + 1] - ring[i];
    return deepest / std::sqrt(edge.dot(edge));
  }
};

/// Where the vertices of `ring` lie to the line from p to q; inside is to the left.
inline void find_side(const Vec2& p, const Vec2& q, Ring ring, EdgeSide& side) {
  const double x = q.x() - p.x();
  const double y = q.y() - p.y();
  const Vec2* const v = ring.data();
  const std::size_t n = ring.size();
  std::size_t inside = 0;
  std::uint64_t which = 0;
  const auto distance = [&](std::size_t k) {
    const double d = x * (v[k].y() - p.y()) - y * (v[k].x() - p.x());
    side.distances[k] = d;
    inside += d >= 0;
    which |= std::uint64_t{d >= 0} << k;
    return d;
  };
  if (n <= 8) {
    // Written out for eight, the last vertex again and again: no branch to be mistaken about and
    // no long chain of comparisons (10 ns instead of 17 with -O2).
    const auto vertex = [&](std::size_t k) { return distance(std::min(k, n - 1)); };
    const double d04 = std::max(vertex(0), vertex(4));
    const double d15 = std::max(vertex(1), vertex(5));
    const double d26 = std::max(vertex(2), vertex(6));
    const double d37 = std::max(vertex(3), vertex(7));
    side.deepest = std::max(std::max(d04, d15), std::max(d26, d37));
    inside -= (8 - n) * static_cast<std::size_t>(which >> (n - 1));
  } else {
    side.deepest = distance(0);
    for (std::size_t k = 1; k < n; ++k) side.deepest = std::max(side.deepest, distance(k));
  }
  side.inside = inside;
  side.which = which;
}

/// The vertices inside, which follow each other in a convex ring, and their neighbours. Needs some
/// inside and some outside.
struct InsideRun {
  std::size_t before = 0;
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t after = 0;
  bool unbroken = false;  ///< not so: round-off has vertices next to the line on both of its sides
};
[[nodiscard]] inline InsideRun inside_run(const EdgeSide& side, std::size_t n) {
  const std::uint64_t all = ~std::uint64_t{0} >> (64 - n);
  const std::uint64_t starts = side.which & ~((side.which << 1) | (side.which >> (n - 1))) & all;
  InsideRun run;
  run.unbroken = (starts & (starts - 1)) == 0;
  run.first = static_cast<std::size_t>(std::countr_zero(starts));
  run.before = run.first == 0 ? n - 1 : run.first - 1;
  run.after = run.first + side.inside;
  if (run.after >= n) run.after -= n;
  run.last = run.after == 0 ? n - 1 : run.after - 1;
  return run;
}

/// Where the vertices of `other` lie to edge `i` of `ring`.
[[nodiscard]] inline EdgeSide edge_side(Ring ring, std::size_t i, Ring other) {
  EdgeSide side;
  find_side(ring[i], ring[i + 1 == ring.size() ? 0 : i + 1], other, side);
  return side;
}

}  // namespace riprap
