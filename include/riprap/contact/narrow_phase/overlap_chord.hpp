#pragma once
/// @file
/// Contact line through the two points where the boundaries cross: the default narrow phase.

#include <algorithm>
#include <optional>

#include <riprap/contact/narrow_phase/concepts.hpp>
#include <riprap/contact/narrow_phase/contact_line.hpp>
#include <riprap/contact/narrow_phase/least_translation_contact.hpp>

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
    const CommonPart common = common_part(a, b);
    if (common.empty()) return std::nullopt;
    ContactGeometry contact = contact_line(a, b, common);
    if (!(contact.chord > 0)) return least_translation_contact(a, b, common);
    contact.area = common.properties.area;
    contact.depth = std::min(extent_along(common.polygon.ring(), contact.normal),
                             2 * contact.area / contact.chord);
    return contact;
  }
};

static_assert(NarrowPhase<OverlapChord>);

}  // namespace riprap
