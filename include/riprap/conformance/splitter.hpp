// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the splitter.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <riprap/breakage/splitter/concepts.hpp>
#include <riprap/conformance/units.hpp>
#include <riprap/conformance/violations.hpp>
#include <riprap/core/random.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/geometry/random_polygon.hpp>

namespace riprap {
namespace internal {

struct CrackedPolygon {
  ConvexPolygon polygon;
  Line line;
};

/// Random polygons of about `size` [m] with a line through or beside them.
[[nodiscard]] inline std::vector<CrackedPolygon> cracked_polygons(double size) {
  Random random(1);
  const PolygonShape shape{.most_vertices = 7};
  std::vector<CrackedPolygon> out;
  for (int i = 0; i < 400; ++i) {
    const Vec2 centre = size * Vec2{random.uniform(-20, 20), random.uniform(-20, 20)};
    const ConvexPolygon polygon = random_polygon(shape, size, random).moved({}, centre);
    const double angle = random.uniform(0, 2 * std::numbers::pi);
    const double reach = 0.6 * size;
    out.push_back({polygon,
                   {centre + Vec2{random.uniform(-reach, reach), random.uniform(-reach, reach)},
                    {std::cos(angle), std::sin(angle)}}});
  }
  return out;
}

/// Smallest distance of a vertex from an edge that it should lie to the left of [m].
[[nodiscard]] inline double least_convexity(Ring ring) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 edge = ring[(i + 1) % ring.size()] - ring[i];
    const Vec2 on = ring[(i + 2) % ring.size()] - ring[i];
    least = std::min(least, cross(edge, on) / edge.norm());
  }
  return least;
}

inline void check_pieces(const CrackedPolygon& sample, const CutRings& pieces, double size,
                         AxiomCheck& check) {
  const AreaProperties whole = area_properties(sample.polygon.ring());
  const AreaProperties left = area_properties(pieces.left);
  const AreaProperties right = area_properties(pieces.right);
  // Round-off of coordinates up to 20 sizes from the origin.
  const double round_off = 1e-13 * size;
  check.equal("the areas of the pieces add up to the whole", left.area + right.area, whole.area,
              round_off * size);
  check.equal("the pieces lie where the whole lay: way of their common centroid",
              (left.area * left.centroid + right.area * right.centroid -
               (left.area + right.area) * whole.centroid)
                      .norm() /
                  whole.area,
              0, 10 * round_off);
  for (const std::vector<Vec2>& piece : {pieces.left, pieces.right}) {
    check.at_least("a piece has corners", static_cast<double>(piece.size()), 3);
    check.at_least("a piece is convex and counter-clockwise", least_convexity(piece), 0);
  }
  check.at_least("the left piece lies on the left", sample.line.left_distance(left.centroid), 0);
  check.at_most("the right piece lies on the right", sample.line.left_distance(right.centroid), 0);
}

}  // namespace internal

/// Which axioms a splitter breaks for random polygons of about `size` [m].
template <Splitter S>
[[nodiscard]] Violations splitter_violations(const S& splitter, double size = 0.016) {
  AxiomCheck check;
  for (const internal::CrackedPolygon& sample : internal::cracked_polygons(size)) {
    const Ring ring = sample.polygon.ring();
    const double mean_area = size * size;
    const std::optional<CutRings> pieces = splitter(ring, sample.line, mean_area);
    if (pieces) internal::check_pieces(sample, *pieces, size, check);

    const Line reversed{sample.line.point, -sample.line.direction};
    const std::optional<CutRings> swapped = splitter(ring, reversed, mean_area);
    check.equal("a line turned end for end cuts as well", swapped.has_value(), pieces.has_value(),
                0);
    if (swapped && pieces)
      check.equal("a line turned end for end swaps the pieces", area_properties(swapped->left).area,
                  area_properties(pieces->right).area, 1e-13 * mean_area);
  }
  return std::move(check).violations();
}

/// Which cuts change when ring, line, mean area and splitter are given in other units of length.
/// @param other `splitter` with its parameters in `units`
template <Splitter S>
[[nodiscard]] Violations splitter_unit_violations(const S& splitter, const S& other,
                                                  const Units& units = {}, double size = 0.016) {
  AxiomCheck check;
  for (const internal::CrackedPolygon& sample : internal::cracked_polygons(size)) {
    std::vector<Vec2> ring;
    for (const Vec2& v : sample.polygon) ring.push_back(units.length * v);
    const Line line{units.length * sample.line.point, sample.line.direction};
    const double mean_area = size * size;
    const std::optional<CutRings> pieces = splitter(sample.polygon.ring(), sample.line, mean_area);
    const std::optional<CutRings> same = other(ring, line, units.area() * mean_area);
    check.equal("what is cut in one unit is cut in another", same.has_value(), pieces.has_value(),
                0);
    if (same && pieces)
      check.equal("pieces are the same in other units",
                  area_properties(same->left).area / units.area(),
                  area_properties(pieces->left).area, 1e-12 * mean_area);
  }
  return std::move(check).violations();
}

}  // namespace riprap
