// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <boost/polygon/point_data.hpp>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <map>
#include <utility>

#include <riprap/core/errors.hpp>
#include <riprap/geometry/delaunay.hpp>

namespace riprap {

namespace internal {

/// Twice the area of a triangle, counter-clockwise positive.
[[nodiscard]] inline double doubled_area(const TriangleIndices& t, std::span<const Vec2> points) {
  return cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]);
}

/// The points in integers, over all of 31 bits.
[[nodiscard]] inline std::vector<boost::polygon::point_data<std::int32_t>>
rounded_points(std::span<const Vec2> points) {
  std::vector<boost::polygon::point_data<std::int32_t>> out;
  if (points.empty()) return out;
  Vec2 low = points[0];
  Vec2 high = points[0];
  for (const Vec2& p : points) {
    require_finite("delaunay: coordinate of a point", p.x() + p.y());
    low = componentwise_min(low, p);
    high = componentwise_max(high, p);
  }
  const Vec2 centre = low + 0.5 * (high - low);
  const double extent = std::max(high.x() - low.x(), high.y() - low.y());
  const double scale = extent > 0 ? 0x1p30 / extent : 0;
  for (const Vec2& p : points)
    out.emplace_back(static_cast<std::int32_t>(std::lround(scale * (p.x() - centre.x()))),
                     static_cast<std::int32_t>(std::lround(scale * (p.y() - centre.y()))));
  return out;
}

/// Triangles by the sides that only one of them has: an edge of the triangulation.
class EdgeSides {
 public:
  using Side = std::pair<std::uint32_t, std::uint32_t>;

  explicit EdgeSides(const std::vector<TriangleIndices>& triangles) : triangles_(triangles) {
    for (std::size_t n = 0; n < triangles.size(); ++n)
      for (int k = 0; k < 3; ++k) triangle_at_[side(n, k)] = n;
  }
  [[nodiscard]] Side side(std::size_t triangle, int k) const {
    const TriangleIndices& t = triangles_[triangle];
    return {t[static_cast<std::size_t>(k)], t[static_cast<std::size_t>((k + 1) % 3)]};
  }
  [[nodiscard]] bool at_edge(const Side& s) const {
    return !triangle_at_.contains({s.second, s.first});
  }
  /// Takes a triangle away; calls `visit` with those beside it.
  template <class Visit>
  void remove(std::size_t triangle, Visit&& visit) {
    for (int k = 0; k < 3; ++k) triangle_at_.erase(side(triangle, k));
    for (int k = 0; k < 3; ++k) {
      const Side s = side(triangle, k);
      const auto beside = triangle_at_.find({s.second, s.first});
      if (beside != triangle_at_.end()) visit(beside->second);
    }
  }

 private:
  const std::vector<TriangleIndices>& triangles_;
  std::map<Side, std::size_t> triangle_at_{};
};

}  // namespace internal

RIPRAP_INLINE std::vector<TriangleIndices> delaunay(std::span<const Vec2> points) {
  const auto rounded = internal::rounded_points(points);
  boost::polygon::voronoi_diagram<double> voronoi;
  boost::polygon::construct_voronoi(rounded.begin(), rounded.end(), &voronoi);
  std::vector<TriangleIndices> out;
  // The cells around a vertex of the diagram, counter-clockwise: the corners of a Delaunay polygon.
  for (const auto& vertex : voronoi.vertices()) {
    std::vector<std::uint32_t> corners;
    const auto* const first = vertex.incident_edge();
    const auto* edge = first;
    do {
      corners.push_back(static_cast<std::uint32_t>(edge->cell()->source_index()));
      edge = edge->rot_next();
    } while (edge != first);
    for (std::size_t k = 1; k + 1 < corners.size(); ++k) {
      const TriangleIndices t{corners[0], corners[k], corners[k + 1]};
      if (internal::doubled_area(t, points) > 0) out.push_back(t);
    }
  }
  return out;
}

RIPRAP_INLINE std::vector<TriangleIndices> without_flat_edge(std::vector<TriangleIndices> triangles,
                                                             std::span<const Vec2> points,
                                                             double least_height) {
  require_non_negative("without_flat_edge: least_height", least_height);
  internal::EdgeSides sides(triangles);
  std::vector<bool> removed(triangles.size(), false);
  const auto is_flat = [&](std::size_t n) {
    for (int k = 0; k < 3; ++k) {
      const auto side = sides.side(n, k);
      if (!sides.at_edge(side)) continue;
      const Vec2 along = points[side.second] - points[side.first];
      if (internal::doubled_area(triangles[n], points) < least_height * along.dot(along))
        return true;
    }
    return false;
  };
  std::vector<std::size_t> to_check(triangles.size());
  for (std::size_t n = 0; n < triangles.size(); ++n) to_check[n] = n;
  while (!to_check.empty()) {
    const std::size_t n = to_check.back();
    to_check.pop_back();
    if (removed[n] || !is_flat(n)) continue;
    removed[n] = true;
    sides.remove(n, [&](std::size_t beside) { to_check.push_back(beside); });
  }
  std::vector<TriangleIndices> out;
  for (std::size_t n = 0; n < triangles.size(); ++n)
    if (!removed[n]) out.push_back(triangles[n]);
  return out;
}

}  // namespace riprap
