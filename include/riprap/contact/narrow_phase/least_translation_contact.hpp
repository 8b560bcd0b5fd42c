// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The contact of two rings by the minimum translation that separates them.

#include <algorithm>

#include <riprap/contact/narrow_phase/common_part.hpp>
#include <riprap/contact/pair/contact_geometry.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/geometry/separation.hpp>

namespace riprap {

/// Normal and depth of the least translation, at the centroid of the overlap; the chord is the
/// overlap's extent across the normal.
/// @param common part of a and b, not empty
[[nodiscard]] inline ContactGeometry least_translation_contact(Ring a, Ring b,
                                                               const CommonPart& common) {
  const MinimumTranslation least = minimum_translation(a, b);
  ContactGeometry contact{.normal = least.normal,
                          .point = area_properties(common.polygon.ring()).centroid + a[0],
                          .depth = std::max(least.depth, 0.0),
                          .area = common.area};
  contact.chord = extent_along(common.polygon.ring(), contact.tangent());
  return contact;
}

}  // namespace riprap
