#pragma once
/// @file
/// What two overlapping rings have in common.

#include <cmath>
#include <cstddef>
#include <optional>

#include <riprap/geometry/overlap.hpp>
#include <riprap/geometry/polygon_properties.hpp>

namespace riprap {

/// What two rings have in common, in coordinates relative to the first vertex of the first.
struct CommonPart {
  /// Lengths below this share of a particle's size carry no information.
  static constexpr double negligible = 1e-10;

  OverlapPolygon polygon;
  double area = 0;  ///< [m^2]
  double size = 0;  ///< of the first ring, to a factor of two or so [m]

  [[nodiscard]] bool empty() const { return polygon.size == 0; }

  /// The edge through which one ring enters the other, if it is the only one of its ring that
  /// bounds the common part.
  [[nodiscard]] std::optional<EdgeSource> only_edge_of_one() const {
    std::size_t of_b = 0;
    for (std::size_t i = 0; i < polygon.size; ++i) of_b += polygon.sources[i].of_b;
    if (polygon.size < 3 || (of_b != 1 && polygon.size - of_b != 1)) return std::nullopt;
    std::size_t i = 0;
    while (polygon.sources[i].of_b != (of_b == 1)) ++i;
    return polygon.sources[i];
  }
};

/// Empty where the rings have no area worth the name in common.
[[nodiscard]] inline CommonPart common_part(Ring a, Ring b) {
  const Vec2 across = a[a.size() / 2] - a[0];
  const double size = std::sqrt(across.dot(across));
  constexpr double negligible = CommonPart::negligible;
  CommonPart part{overlap(a, b, a[0], negligible * size), 0, size};
  part.area = polygon_area(part.polygon.ring());
  // A corner's overlap shrinks with the square of its depth, so this is a squared length.
  if (part.area <= negligible * size * negligible * size) part.polygon.size = 0;
  return part;
}

}  // namespace riprap
