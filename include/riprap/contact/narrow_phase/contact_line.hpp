// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The line through the two points where the boundaries of two rings cross.

#include <cmath>

#include <riprap/contact/narrow_phase/common_part.hpp>
#include <riprap/contact/pair/contact_geometry.hpp>

namespace riprap {

namespace internal {

// A crossing at the end of an edge is the mark of flush edges, where labels are arbitrary.
[[nodiscard]] inline bool ends_at(Ring ring, std::size_t edge, const Vec2& x, double tolerance) {
  const Vec2& p = ring[edge];
  const Vec2& q = ring[edge + 1 == ring.size() ? 0 : edge + 1];
  return (x - p).cwiseAbs().maxCoeff() <= tolerance || (x - q).cwiseAbs().maxCoeff() <= tolerance;
}

}  // namespace internal

/// Normal, point and chord of the line through the two points where the boundaries cross; chord 0
/// where there are not exactly two proper crossings.
/// @param part common to a and b
[[nodiscard]] inline ContactGeometry contact_line(Ring a, Ring b, const CommonPart& part) {
  const OverlapPolygon& common = part.polygon;
  const double tolerance = 10 * part.tolerance;
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
    if (internal::ends_at(a, of_a.edge, absolute, tolerance) ||
        internal::ends_at(b, of_b.edge, absolute, tolerance))
      return contact;
    (before.of_b ? enters_a : leaves_a) = x;
  }
  if (changes != 2) return contact;
  const Vec2 chord = leaves_a - enters_a;
  const double length = std::sqrt(chord.dot(chord));
  if (length <= tolerance) return contact;
  // Going counter-clockwise from enters_a to leaves_a the boundary is a's, and lies to the right
  // of the chord: that is the side on which a reaches into b.
  contact.normal = -perpendicular(chord) / length;
  contact.point = a[0] + 0.5 * (enters_a + leaves_a);
  contact.chord = length;
  return contact;
}

}  // namespace riprap
