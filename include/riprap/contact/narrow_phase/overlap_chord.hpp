#pragma once
/// @file
/// Contact line through the two points where the boundaries cross: the default narrow phase.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <riprap/contact/narrow_phase/concepts.hpp>
#include <riprap/geometry/overlap.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/geometry/separation.hpp>

namespace riprap {

/// The contact line of POLY (Mirghasemi, Rothenburg and Matyas 1997). Where the two boundaries
/// cross exactly twice, the contact line is the chord through the crossings: the normal is
/// perpendicular to it, the force acts at its middle, and the depth is the smaller of the overlap's
/// extent along the normal and twice its area over the chord (equal for a corner in an edge).
/// Elsewhere (containment, flush edges, more crossings) normal and depth come from the minimum
/// translation and the point is the overlap's centroid.
struct OverlapChord {
  using Memory = SeparatingEdge;

  [[nodiscard]] std::optional<ContactGeometry> operator()(Ring a, Ring b, Memory& memory) const {
    if (separated(a, b, memory)) return std::nullopt;
    const Vec2 across = a[a.size() / 2] - a[0];
    const double size = std::sqrt(across.dot(across));
    const OverlapPolygon common = overlap(a, b, a[0], negligible * size);
    if (common.size == 0) return std::nullopt;
    const AreaProperties properties = area_properties(common.ring());
    // A corner's overlap shrinks with the square of its depth, so this is a squared length.
    if (properties.area <= negligible * size * negligible * size) return std::nullopt;
    ContactGeometry contact = chord_contact(a, b, common, size);
    contact.area = properties.area;
    if (contact.chord > 0) {
      contact.depth =
          std::min(extent_along(common, contact.normal), 2 * properties.area / contact.chord);
    } else {
      const MinimumTranslation least = minimum_translation(a, b);
      contact.normal = least.normal;
      contact.depth = std::max(least.depth, 0.0);
      contact.chord = extent_along(common, contact.tangent());
      contact.point = properties.centroid + a[0];
    }
    return contact;
  }

 private:
  /// Lengths below this share of a particle's size carry no information.
  static constexpr double negligible = 1e-10;

  // Normal, point and chord if there are exactly two proper crossings; chord 0 otherwise.
  [[nodiscard]] static ContactGeometry chord_contact(Ring a, Ring b, const OverlapPolygon& common,
                                                     double size) {
    ContactGeometry contact;
    Vec2 enters_a;  // where the overlap's boundary changes from b's edges to a's
    Vec2 leaves_a;
    int changes = 0;
    for (std::size_t i = 0; i < common.size; ++i) {
      const EdgeSource before = common.sources[i == 0 ? common.size - 1 : i - 1];
      const EdgeSource after = common.sources[i];
      if (before.of_b == after.of_b) continue;
      ++changes;
      const Vec2& x = common.vertices[i];
      const Vec2 absolute = x + a[0];
      const EdgeSource of_a = before.of_b ? after : before;
      const EdgeSource of_b = before.of_b ? before : after;
      if (ends_at(a, of_a.edge, absolute, 10 * negligible * size) ||
          ends_at(b, of_b.edge, absolute, 10 * negligible * size))
        return contact;
      (before.of_b ? enters_a : leaves_a) = x;
    }
    if (changes != 2) return contact;
    const Vec2 chord = leaves_a - enters_a;
    const double length = std::sqrt(chord.dot(chord));
    if (length <= 10 * negligible * size) return contact;
    // Going counter-clockwise from enters_a to leaves_a the boundary is a's, and lies to the right
    // of the chord: that is the side on which a reaches into b.
    contact.normal = -perpendicular(chord) / length;
    contact.point = a[0] + 0.5 * (enters_a + leaves_a);
    contact.chord = length;
    return contact;
  }

  // A crossing at the end of an edge is the mark of flush edges, where labels are arbitrary.
  [[nodiscard]] static bool ends_at(Ring ring, std::size_t edge, const Vec2& x, double tolerance) {
    const Vec2& p = ring[edge];
    const Vec2& q = ring[edge + 1 == ring.size() ? 0 : edge + 1];
    return (x - p).cwiseAbs().maxCoeff() <= tolerance || (x - q).cwiseAbs().maxCoeff() <= tolerance;
  }

  [[nodiscard]] static double extent_along(const OverlapPolygon& polygon, const Vec2& axis) {
    double low = axis.dot(polygon.vertices[0]);
    double high = low;
    for (std::size_t i = 1; i < polygon.size; ++i) {
      const double s = axis.dot(polygon.vertices[i]);
      low = std::min(low, s);
      high = std::max(high, s);
    }
    return high - low;
  }
};

static_assert(NarrowPhase<OverlapChord>);

}  // namespace riprap
