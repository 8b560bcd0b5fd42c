// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include <riprap/core/argsort.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/random.hpp>
#include <riprap/geometry/line_side.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/geometry/voronoi_cells.hpp>

namespace riprap {

namespace internal {

/// A random point of a convex ring, uniform over its area.
[[nodiscard]] inline Vec2 random_point(Ring ring, Random& random) {
  // In one of the triangles from the first vertex, by their areas.
  double left = random.uniform(0, polygon_area(ring));
  std::size_t k = 1;
  for (; k + 2 < ring.size(); ++k) {
    const double area = polygon_area(std::array{ring[0], ring[k], ring[k + 1]});
    if (left < area) break;
    left -= area;
  }
  const double along = std::sqrt(random.uniform(0, 1));
  const double across = random.uniform(0, 1);
  return ring[0] + along * ((ring[k] - ring[0]) + across * (ring[k + 1] - ring[k]));
}

/// Points of a ring, each the farthest from those before it of ten random ones (D. P. Mitchell,
/// Proc. SIGGRAPH 1991).
[[nodiscard]] inline std::vector<Vec2> spread_points(Ring ring, unsigned count, Random& random) {
  std::vector<Vec2> points;
  while (points.size() < count) {
    Vec2 best{0, 0};
    double farthest = -1;
    for (int candidate = 0; candidate < 10; ++candidate) {
      const Vec2 p = random_point(ring, random);
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vec2& q : points) nearest = std::min(nearest, (p - q).squaredNorm());
      if (nearest > farthest) {
        farthest = nearest;
        best = p;
      }
    }
    points.push_back(best);
  }
  return points;
}

/// The part of a convex ring that is nearer to p than to q. Vertices that stay keep their bits.
inline void keep_nearer(std::vector<Vec2>& ring, const Vec2& p, const Vec2& q,
                        std::vector<Vec2>& spare) {
  const Vec2 away = q - p;
  const Vec2 middle = p + 0.5 * away;
  spare.clear();
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vec2& from = ring[k];
    const Vec2& to = ring[next_vertex(k, ring.size())];
    const double before = away.dot(from - middle);
    const double after = away.dot(to - middle);
    if (before <= 0) spare.push_back(from);
    if ((before < 0 && after > 0) || (before > 0 && after < 0))
      spare.push_back(from + before / (before - after) * (to - from));
  }
  std::swap(ring, spare);
}

/// The cell of each point, clipped to a ring.
[[nodiscard]] inline std::vector<std::vector<Vec2>> clipped_cells(Ring ring,
                                                                  std::span<const Vec2> points) {
  std::vector<std::vector<Vec2>> cells;
  std::vector<Vec2> spare;
  std::vector<double> distances(points.size());
  for (const Vec2& p : points) {
    std::vector<Vec2> cell(ring.begin(), ring.end());
    for (std::size_t k = 0; k < points.size(); ++k) distances[k] = (points[k] - p).squaredNorm();
    // The nearest first, until the next is too far away to cut the cell.
    for (const std::size_t k : argsort(distances)) {
      double farthest = 0;
      for (const Vec2& v : cell) farthest = std::max(farthest, (v - p).squaredNorm());
      if (distances[k] > 4 * farthest) break;
      if (distances[k] > 0) keep_nearer(cell, p, points[k], spare);
    }
    cells.push_back(std::move(cell));
  }
  return cells;
}

/// Gives vertices that are nearer to each other than `tolerance` [m] the place of one of them, a
/// corner or a point of the boundary before others, and those from the left before others.
class VertexJoiner {
 public:
  VertexJoiner(Ring ring, const std::vector<std::vector<Vec2>>& cells, double tolerance)
      : ring_(ring), tolerance_(tolerance), before_(ring.begin(), ring.end()) {
    for (const auto& cell : cells) before_.insert(before_.end(), cell.begin(), cell.end());
    for (const Vec2& v : before_) x_.push_back(v.x());
    order_ = argsort(x_);
    place_.resize(order_.size());
    for (std::size_t n = 0; n < order_.size(); ++n) place_[order_[n]] = n;
    joined_.assign(order_.size(), false);
    after_ = before_;
    for (std::size_t k = 0; k < ring.size(); ++k) gather(k);
    for (const std::size_t k : order_)
      if (!joined_[k] && at_boundary(before_[k])) gather(k);
    for (const std::size_t k : order_)
      if (!joined_[k]) gather(k);
  }

  void move(std::vector<std::vector<Vec2>>& cells) const {
    std::size_t k = ring_.size();
    for (auto& cell : cells) {
      for (Vec2& v : cell) v = after_[k++];
      cell.erase(std::unique(cell.begin(), cell.end()), cell.end());
      while (cell.size() > 1 && cell.front() == cell.back()) cell.pop_back();
    }
  }

 private:
  /// To round-off: the distances from the edges are compared with 1e-5 tolerances.
  [[nodiscard]] bool at_boundary(const Vec2& v) const {
    return !inside_other_edges(ring_, ring_.size(), v, 1e-5 * tolerance_);
  }
  void gather(std::size_t k) {
    const auto take = [&](std::size_t other) {
      if (joined_[other] || (before_[other] - before_[k]).norm() > tolerance_) return;
      joined_[other] = true;
      after_[other] = before_[k];
    };
    for (std::size_t n = place_[k]; n < order_.size() && x_[order_[n]] - x_[k] <= tolerance_; ++n)
      take(order_[n]);
    for (std::size_t n = place_[k]; n-- > 0 && x_[k] - x_[order_[n]] <= tolerance_;)
      take(order_[n]);
  }

  Ring ring_;
  double tolerance_;
  std::vector<Vec2> before_, after_;  // of the ring, then of the cells
  std::vector<double> x_;
  std::vector<std::size_t> order_, place_;  // from left to right
  std::vector<bool> joined_;
};

}  // namespace internal

RIPRAP_INLINE void VoronoiPoints::validate() const {
  require(count >= 1 && count <= 20000, "VoronoiPoints.count", count, "must lie in [1, 20000]");
  require(relaxations <= 1000, "VoronoiPoints.relaxations", relaxations, "must be at most 1000");
}

RIPRAP_INLINE unsigned count_of_cells(double area, double mean_diameter) {
  require_positive("count_of_cells: area", area);
  require_positive("count_of_cells: mean_diameter", mean_diameter);
  const double share = area / (0.25 * std::numbers::pi * mean_diameter * mean_diameter);
  require(share < 1e9, "count_of_cells: area / cell area", share, "must be below 1e9");
  return static_cast<unsigned>(std::max(1L, std::lround(share)));
}

RIPRAP_INLINE std::vector<ConvexPolygon> voronoi_cells(const ConvexPolygon& polygon,
                                                       const VoronoiPoints& options) {
  options.validate();
  Random random(options.seed);
  const Ring ring = polygon.ring();
  std::vector<Vec2> points = internal::spread_points(ring, options.count, random);
  auto cells = internal::clipped_cells(ring, points);
  for (unsigned n = 0; n < options.relaxations; ++n) {
    for (std::size_t k = 0; k < points.size(); ++k) points[k] = area_properties(cells[k]).centroid;
    cells = internal::clipped_cells(ring, points);
  }
  const double size = equivalent_diameter(polygon_area(ring) / options.count);
  internal::VertexJoiner(ring, cells, 1e-5 * size).move(cells);
  std::vector<ConvexPolygon> out;
  double area = 0;
  for (auto& cell : cells) {
    auto convex = try_convex_polygon(std::move(cell));
    if (!convex) break;
    area += polygon_area(convex->ring());
    out.push_back(*std::move(convex));
  }
  const double share = area / polygon_area(ring);
  require(std::abs(share - 1) < 1e-9, "voronoi_cells: area of the cells / area of the polygon",
          share, "must be 1: the polygon is too thin for this count, or far from the origin");
  return out;
}

}  // namespace riprap
