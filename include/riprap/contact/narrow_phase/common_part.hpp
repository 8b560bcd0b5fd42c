#pragma once
/// @file
/// What two overlapping rings have in common.

#include <cmath>

#include <riprap/geometry/overlap.hpp>
#include <riprap/geometry/polygon_properties.hpp>

namespace riprap {

/// What two rings have in common, in coordinates relative to the first vertex of the first.
struct CommonPart {
  /// Lengths below this share of a particle's size carry no information.
  static constexpr double negligible = 1e-10;

  OverlapPolygon polygon;
  AreaProperties properties;
  double size = 0;  ///< of the first ring, to a factor of two or so [m]

  [[nodiscard]] bool empty() const { return polygon.size == 0; }
};

/// Empty where the rings have no area worth the name in common.
[[nodiscard]] inline CommonPart common_part(Ring a, Ring b) {
  const Vec2 across = a[a.size() / 2] - a[0];
  const double size = std::sqrt(across.dot(across));
  constexpr double negligible = CommonPart::negligible;
  CommonPart part{overlap(a, b, a[0], negligible * size), {}, size};
  part.properties = area_properties(part.polygon.ring());
  // A corner's overlap shrinks with the square of its depth, so this is a squared length.
  if (part.properties.area <= negligible * size * negligible * size) part.polygon.size = 0;
  return part;
}

}  // namespace riprap
