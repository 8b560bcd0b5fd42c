// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What two overlapping rings have in common.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include <riprap/geometry/corner_edge_overlap.hpp>
#include <riprap/geometry/line_side.hpp>
#include <riprap/geometry/overlap.hpp>
#include <riprap/geometry/polygon_properties.hpp>

namespace riprap {

/// What two rings have in common, in coordinates relative to the first vertex of the first.
struct CommonPart {
  OverlapPolygon polygon;
  double area = 0;       ///< [m^2]
  double size = 0;       ///< of the smaller ring, to a factor of two or so [m]
  double tolerance = 0;  ///< lengths below carry no information: round-off of coordinates [m]

  [[nodiscard]] bool empty() const { return polygon.size == 0; }

  /// The corner-edge feature of the overlap, if it is one or two vertices beyond a single edge.
  struct Entry {
    bool of_b = false;  ///< whose edge it is
    CornerEdgeFeature place;
  };
  [[nodiscard]] std::optional<Entry> entry(std::size_t vertices_of_a,
                                           std::size_t vertices_of_b) const {
    if (polygon.size != 3 && polygon.size != 4) return std::nullopt;
    const std::size_t of_b = edges_of_b();
    if (of_b != 1 && polygon.size - of_b != 1) return std::nullopt;
    std::size_t i = 0;
    while (polygon.sources[i].of_b != (of_b == 1)) ++i;
    // Going round, the edges of the other ring follow.
    const EdgeSource going_in = polygon.sources[next_vertex(i, polygon.size)];
    const std::size_t other_size = of_b == 1 ? vertices_of_a : vertices_of_b;
    const std::size_t first = next_vertex(going_in.edge, other_size);
    const std::size_t ring_size = of_b == 1 ? vertices_of_b : vertices_of_a;
    return Entry{of_b == 1, corner_edge_feature(ring_size, polygon.sources[i].edge, other_size,
                                                first, polygon.size - 2)};
  }

  /// The vertices of a and b that lie in the other, if it is one of each.
  [[nodiscard]] std::optional<std::pair<std::uint8_t, std::uint8_t>> corners() const {
    if (polygon.size != 4 || edges_of_b() != 2) return std::nullopt;
    for (std::size_t i = 0; i < 4; ++i) {
      const auto source = [&](std::size_t k) { return polygon.sources[(i + k) % 4]; };
      if (!source(0).of_b && !source(1).of_b) return std::pair(source(1).edge, source(3).edge);
    }
    return std::nullopt;
  }

 private:
  [[nodiscard]] std::size_t edges_of_b() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < polygon.size; ++i) count += polygon.sources[i].of_b;
    return count;
  }
};

namespace internal {

/// An order of two rings that does not depend on which of them is called the first one: degenerate
/// overlaps are the same for a and b as for b and a.
[[nodiscard]] inline bool comes_first(Ring a, Ring b) {
  return std::ranges::lexicographical_compare(a, b, [](const Vec2& p, const Vec2& q) {
    return std::pair(p.x(), p.y()) < std::pair(q.x(), q.y());
  });
}

}  // namespace internal

/// Empty where the rings have no area above round-off in common. Size and tolerance do not depend
/// on the order of the rings.
[[nodiscard]] inline CommonPart common_part(Ring a, Ring b) {
  const auto squared_size = [](Ring ring) {
    return (ring[ring.size() / 2] - ring[0]).squaredNorm();
  };
  const double farthest = std::max(a[0].lpNorm<Eigen::Infinity>(), b[0].lpNorm<Eigen::Infinity>());
  CommonPart part;
  part.size = std::sqrt(std::min(squared_size(a), squared_size(b)));
  part.tolerance = 1e-13 * part.size + 4e-16 * farthest;
  part.polygon = overlap(a, b, a[0], part.tolerance);
  part.area = polygon_area(part.polygon.ring());
  // A corner's overlap shrinks with the square of its depth, so this is a squared length.
  if (part.area <= part.tolerance * part.tolerance) part.polygon.size = 0;
  return part;
}

}  // namespace riprap
