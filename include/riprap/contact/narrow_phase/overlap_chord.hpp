// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Contact line through the two points where the boundaries cross.

#include <algorithm>
#include <cmath>

#include <riprap/contact/narrow_phase/classified_overlap.hpp>
#include <riprap/contact/narrow_phase/concepts.hpp>
#include <riprap/contact/narrow_phase/contact_line.hpp>
#include <riprap/contact/narrow_phase/least_translation_contact.hpp>

namespace riprap {

/// Where the two boundaries cross exactly twice, the contact line is the chord through the
/// crossings: the normal is perpendicular to it, the force acts at its middle, and the depth is the
/// smaller of the overlap's extent along the normal and twice its area over the chord (equal for a
/// corner in an edge). Elsewhere (containment, flush edges, more crossings) normal and depth come
/// from the minimum translation and the point is the overlap's centroid.
///
/// Our reading of the contact line of POLY (Mirghasemi, Rothenburg and Matyas 1997). The force at
/// the middle of the chord is not the gradient of any energy: see docs/theory/contact.md.
struct OverlapChord : ClassifiedOverlap<OverlapChord> {
  template <class N>
  using Edge = internal::CornerEdgeOverlaps<N>;
  template <class N>
  using Corners = internal::CornerCornerOverlaps<N>;

  [[nodiscard, gnu::always_inline]] static ContactGeometry of_edge(const CornerEdgeOverlap& cap,
                                                                   double sign) {
    return {.normal = {sign * cap.normal.x(), sign * cap.normal.y()},
            .point = cap.middle,
            .depth = cap.one_vertex ? cap.depth : std::min(cap.depth, 2 * cap.area / cap.chord),
            .area = cap.area,
            .chord = cap.chord};
  }

  [[nodiscard]] static ContactGeometry of_corners(const CornerCornerOverlap& lens) {
    const double x = lens.leaves_a.x() - lens.enters_a.x();
    const double y = lens.leaves_a.y() - lens.enters_a.y();
    const double chord = std::sqrt(x * x + y * y);
    const double scale = 1 / chord;
    // Of a quadrangle over its diagonal the extent is twice the area over it.
    return {.normal = {y * scale, -x * scale},
            .point = 0.5 * (lens.leaves_a + lens.enters_a),
            .depth = 2 * lens.area * scale,
            .area = lens.area,
            .chord = chord};
  }

  [[nodiscard]] static ContactGeometry of_common_part(Ring a, Ring b, const CommonPart& common) {
    ContactGeometry contact = contact_line(a, b, common);
    if (!(contact.chord > 0)) return least_translation_contact(a, b, common);
    contact.area = common.area;
    contact.depth = std::min(extent_along(common.polygon.ring(), contact.normal),
                             2 * contact.area / contact.chord);
    return contact;
  }
};

static_assert(NarrowPhase<OverlapChord>);

}  // namespace riprap
