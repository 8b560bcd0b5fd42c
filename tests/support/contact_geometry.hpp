// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Comparisons of contact geometry.

#include <doctest/doctest.h>

#include <riprap/contact/narrow_phase/polygon_moments.hpp>
#include <riprap/contact/pair/contact_geometry.hpp>
#include <support/near.hpp>

namespace riprap::test {

[[nodiscard]] inline bool same_bits(const ContactGeometry& p, const ContactGeometry& q) {
  return p.normal == q.normal && p.point == q.point && p.depth == q.depth && p.area == q.area &&
         p.chord == q.chord && p.depth_gradient == q.depth_gradient;
}

/// The contact is that of the moments of its overlap, to `digits` [m].
inline void check_moments(const ContactGeometry& contact, const PolygonMoments& m, double digits) {
  CHECK(contact.area == near(m.area, digits));
  CHECK(contact.depth == near(m.depth, digits));
  const Vec2 force = contact.depth_gradient * contact.normal;
  CHECK((force - m.gradient).norm() <= 10 * digits);
  CHECK(cross(contact.point - m.centroid, force) == near(m.rotation, 10 * digits));
  CHECK((contact.point - m.centroid).dot(contact.normal) == near(0, digits));
}

}  // namespace riprap::test
