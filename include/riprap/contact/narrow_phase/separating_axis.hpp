// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Contact by the minimum translation that separates two rings.

#include <cmath>
#include <optional>
#include <utility>

#include <riprap/contact/narrow_phase/concepts.hpp>
#include <riprap/contact/narrow_phase/contact_line.hpp>
#include <riprap/contact/narrow_phase/least_translation_contact.hpp>

namespace riprap {

/// Normal and depth are direction and length of the minimum translation that separates the rings
/// (separating axes: Gottschalk, Lin and Manocha 1996), the point is the centroid of the overlap.
/// The normal jumps where two edges tie; OverlapChord's turns from one to the other.
///
/// Where the boundaries cross exactly twice the chord is the projection of OverlapChord's across
/// the normal: the rate at which the area changes along it, so that the force of OverlapAreaSpring
/// is the slope of its energy along the normal. The slope across is left out: that law is
/// conservative with OverlapChord only. Elsewhere the chord is the overlap's extent.
struct SeparatingAxis {
  using Cache = SeparatingEdge;

  [[nodiscard]] std::optional<ContactGeometry> operator()(Ring a, Ring b, Cache& cache) const {
    if (separated(a, b, cache)) return std::nullopt;
    cache.gap = 0;
    // Of equal depths the first is taken: in an order that does not depend on that of the
    // arguments, swapped rings give the same contact.
    const bool swapped = internal::comes_first(b, a);
    if (swapped) std::swap(a, b);
    const CommonPart common = common_part(a, b);
    if (common.empty()) return std::nullopt;
    ContactGeometry contact = least_translation_contact(a, b, common);
    if (const ContactGeometry line = contact_line(a, b, common); line.chord > 0)
      contact.chord = line.chord * std::abs(line.normal.dot(contact.normal));
    if (swapped) contact.normal = -contact.normal;
    return contact;
  }

  /// Of the last call that found an edge between the rings; else nothing is known [m].
  [[nodiscard]] double clearance(const Cache& cache) const { return cache.gap; }
};

static_assert(NarrowPhase<SeparatingAxis>);

}  // namespace riprap
