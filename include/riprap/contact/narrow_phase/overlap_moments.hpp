// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Depth from the second moments of the overlap, with its exact gradient: the default narrow phase.

#include <cmath>
#include <cstddef>

#include <riprap/contact/narrow_phase/classified_overlap.hpp>
#include <riprap/contact/narrow_phase/concepts.hpp>
#include <riprap/contact/narrow_phase/corner_moments.hpp>
#include <riprap/contact/narrow_phase/edge_moments.hpp>
#include <riprap/contact/narrow_phase/least_translation_contact.hpp>
#include <riprap/contact/narrow_phase/polygon_moments.hpp>

namespace riprap {

/// depth^2 = 24 det S / (A tr S), with A the area of the overlap and S its second moments about
/// its centroid. The depth is a function of the overlap's shape alone, without classes, and normal,
/// point and `depth_gradient` are its exact gradient with respect to any rigid motion: a normal
/// force U'(depth) * depth_gradient does no work round a closed path (the condition of Feng, Han
/// and Owen 2012). Derivation and limits: docs/theory/contact.md.
///
/// A right-angled corner in an edge has its depth below the edge, at any tilt, with the force
/// through its tip; sharper corners have less. For a thin overlap of two faces depth^2 is the sum
/// of the squares of the depths at both ends. Where one ring holds the other, or the overlap is
/// symmetrical in such a way that no translation changes it, the gradient is zero.
struct OverlapMoments : ClassifiedOverlap<OverlapMoments> {
  template <class N>
  using Edge = internal::EdgeMoments<N>;
  template <class N>
  using Corners = internal::CornerMoments<N>;

  [[nodiscard, gnu::always_inline]] static ContactGeometry of_edge(const ContactGeometry& contact,
                                                                   double sign) {
    ContactGeometry pushing = contact;
    pushing.normal = {sign * contact.normal.x(), sign * contact.normal.y()};
    return pushing;
  }

  [[nodiscard, gnu::always_inline]] static const ContactGeometry&
  of_corners(const ContactGeometry& contact) {
    return contact;
  }

  [[nodiscard]] static ContactGeometry of_common_part(Ring a, Ring b, const CommonPart& common) {
    const PolygonMoments moments = polygon_moments(common.polygon);
    // Far above round-off, far below any gradient that is not zero by symmetry.
    if (moments.gradient.squaredNorm() > 1e-24) {
      ContactGeometry contact = contact_of(moments, a[0]);
      contact.chord = extent_along(common.polygon.ring(), contact.tangent());
      return contact;
    }
    ContactGeometry contact = least_translation_contact(a, b, common);
    contact.depth = moments.depth;
    contact.depth_gradient = 0;
    return contact;
  }

 private:
  // The point is where the line of action comes closest to the centroid.
  [[nodiscard]] static ContactGeometry contact_of(const PolygonMoments& m, const Vec2& origin) {
    const double gradient = std::sqrt(m.gradient.squaredNorm());
    const Vec2 normal = m.gradient / gradient;
    return {.normal = normal,
            .point = origin + m.centroid - (m.rotation / gradient) * perpendicular(normal),
            .depth = m.depth,
            .area = m.area,
            .depth_gradient = gradient};
  }
};

static_assert(NarrowPhase<OverlapMoments>);

}  // namespace riprap
