// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Pairs of polygons that overlap, and calls of narrow phases for them.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include <riprap/contact/pair/contact_geometry.hpp>
#include <riprap/core/random.hpp>
#include <riprap/geometry/overlap.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <support/polygons.hpp>

namespace riprap::test {

/// The contact by a narrow phase with an empty cache.
template <class Narrow>
[[nodiscard]] std::optional<ContactGeometry> contact_of(const ConvexPolygon& a,
                                                        const ConvexPolygon& b) {
  typename Narrow::Cache cache;
  return Narrow{}(a.ring(), b.ring(), cache);
}

/// 0 where the two keep apart.
[[nodiscard]] inline double overlap_area(const ConvexPolygon& a, const ConvexPolygon& b) {
  return area_properties(overlap(a.ring(), b.ring(), a[0], 0).ring()).area;
}

/// A triangle that stands on its tip at `tip`: its sides rise at `left` and `right` [rad] from the
/// horizontal.
[[nodiscard]] inline ConvexPolygon tip_down(const Vec2& tip, double left, double right) {
  return {tip, tip + Vec2{std::cos(right), std::sin(right)},
          tip + Vec2{-std::cos(left), std::sin(left)}};
}

/// Visits pairs of sharp polygons of about unit size with small to large overlaps.
template <class Visit>
void for_random_pairs(int count, Visit&& visit) {
  Random random(42);
  for (int found = 0; found < count;) {
    const ConvexPolygon a = random_polygon({}, random.uniform(0.7, 1.3), random);
    const ConvexPolygon b = random_polygon({}, random.uniform(0.7, 1.3), random);
    const Rotation direction = Rotation::from_angle(random.uniform(0, 7));
    const ConvexPolygon moved = b.moved({}, random.uniform(0.3, 1.3) * (direction * Vec2{1, 0}));
    if (overlap_area(a, moved) <= 0) continue;
    ++found;
    visit(a, moved);
  }
}

/// Visits such pairs with the contact by a narrow phase.
template <class Narrow, class Visit>
void for_random_contacts(int count, Visit&& visit) {
  for_random_pairs(
      count, [&](const auto& a, const auto& b) { visit(a, b, contact_of<Narrow>(a, b).value()); });
}

/// Overlap lost per shift of b along `direction`, by a central difference.
[[nodiscard]] inline double area_slope(const ConvexPolygon& a, const ConvexPolygon& b,
                                       const Vec2& direction) {
  const double s = 1e-6;
  return (overlap_area(a, shifted(b, -s * direction)) -
          overlap_area(a, shifted(b, s * direction))) /
         (2 * s);
}

/// How often two boundaries cross, edge by edge.
[[nodiscard]] inline int crossings(const ConvexPolygon& a, const ConvexPolygon& b) {
  const auto parts = [](const Vec2& p, const Vec2& q, const Vec2& u, const Vec2& v) {
    return (cross(q - p, u - p) > 0) != (cross(q - p, v - p) > 0);
  };
  int count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < b.size(); ++j) {
      const Vec2& p = a[i];
      const Vec2& q = a[(i + 1) % a.size()];
      const Vec2& u = b[j];
      const Vec2& v = b[(j + 1) % b.size()];
      if (parts(p, q, u, v) && parts(u, v, p, q)) ++count;
    }
  return count;
}

inline void check_same(const ContactGeometry& p, const ContactGeometry& q, double tolerance) {
  CHECK(std::abs(p.depth - q.depth) <= tolerance);
  CHECK(std::abs(p.area - q.area) <= tolerance);
  CHECK(std::abs(p.chord - q.chord) <= tolerance);
  CHECK((p.point - q.point).norm() <= tolerance);
  // A normal is as uncertain as the ends of its chord over their distance.
  CHECK((p.normal - q.normal).norm() * q.chord <= 2 * tolerance);
}

/// A contact moves rigidly with its bodies, whichever of their vertices is called the first.
template <class Narrow>
void check_contacts_move_rigidly() {
  const Rotation turn = Rotation::from_angle(0.77);
  for (const Vec2& shift : {Vec2{0, 0}, Vec2{-3, 8}, Vec2{700, -600}}) {
    // The last bits of coordinates over the distance.
    const double tolerance = 1e-13 * std::max(1.0, shift.norm());
    for_random_contacts<Narrow>(150, [&](const auto& a, const auto& b,
                                         const ContactGeometry& contact) {
      const auto moved =
          contact_of<Narrow>(begun_at(a, 1).moved(turn, shift), begun_at(b, 2).moved(turn, shift));
      REQUIRE(moved);
      ContactGeometry back = *moved;
      back.normal = turn.inverse_times(moved->normal);
      back.point = turn.inverse_times(moved->point - shift);
      check_same(back, contact, tolerance);
    });
  }
}

}  // namespace riprap::test
