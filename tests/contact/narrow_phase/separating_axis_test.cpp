// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/narrow_phase/separating_axis.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <utility>

#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <support/near.hpp>
#include <support/overlapping_pairs.hpp>
#include <support/polygons.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using test::area_slope;
using test::check_same;
using test::crossings;
using test::for_random_contacts;
using test::near;
using test::near_relative;
using test::pi;
using test::rectangle;
using test::shifted;

namespace {

constexpr auto contact_of = test::contact_of<SeparatingAxis>;

bool same_bits(const ContactGeometry& p, const ContactGeometry& q) {
  return std::memcmp(&p, &q, sizeof p) == 0;
}

}  // namespace

TEST_CASE("a corner in an edge is pushed across the edge, at the centroid of its tip") {
  const ConvexPolygon floor = rectangle({0, -1}, 4, 2);
  for (const double depth : {0.1, 1e-3, 1e-6})
    for (const auto& [left, right] :
         {std::pair{pi / 4, pi / 4}, std::pair{0.3, 1.2}, std::pair{1.5, 0.2}}) {
      CAPTURE(depth);
      const double to_left = depth / std::tan(left);
      const double to_right = depth / std::tan(right);
      const auto contact = contact_of(floor, test::tip_down({0.2, -depth}, left, right));
      REQUIRE(contact);
      // Coordinates of size 4 end in digits of 4e-16.
      const double tolerance = 1e-14;
      CHECK((contact->normal - Vec2{0, 1}).norm() <= tolerance);
      CHECK(std::abs(contact->depth - depth) <= tolerance);
      CHECK(std::abs(contact->chord - (to_left + to_right)) <= 10 * tolerance);
      const Vec2 centroid{0.2 + (to_right - to_left) / 3, -depth / 3};
      CHECK((contact->point - centroid).norm() <= 10 * tolerance);
      CHECK(std::abs(contact->area - 0.5 * depth * (to_left + to_right)) <= 10 * tolerance * depth);
    }
}

TEST_CASE("a corner in a corner is pushed along the narrow side of the overlap") {
  const double w = 0.1;
  const double h = 0.2;
  const auto contact = contact_of(rectangle({0, 0}, 1, 1), rectangle({1 - w, 1 - h}, 1, 1));
  REQUIRE(contact);
  CHECK(contact->depth == near_relative(w, 1e-14));
  CHECK(contact->chord == near_relative(h, 1e-14));
  CHECK(contact->area == near_relative(w * h, 1e-14));
  CHECK((contact->normal - Vec2{1, 0}).norm() <= 1e-14);
  CHECK((contact->point - Vec2{0.5 - 0.5 * w, 0.5 - 0.5 * h}).norm() <= 1e-14);
}

TEST_CASE("a face on a wider face has the face in common as chord") {
  for (const double depth : {0.2, 1e-3, 1e-8}) {
    CAPTURE(depth);
    const auto contact =
        contact_of(rectangle({0, -1}, 4, 2), rectangle({0.3, 0.5 - depth}, 1.5, 1));
    REQUIRE(contact);
    CHECK(std::abs(contact->depth - depth) <= 1e-14);
    CHECK(contact->chord == near_relative(1.5, 1e-14));
    CHECK((contact->normal - Vec2{0, 1}).norm() <= 1e-14);
    CHECK((contact->point - Vec2{0.3, -0.5 * depth}).norm() <= 1e-14);
    CHECK(std::abs(contact->area - 1.5 * depth) <= 1e-14);
  }
}

TEST_CASE("a body inside another leaves by the nearest side") {
  const auto contact = contact_of(rectangle({0, 0}, 4, 2), rectangle({1.2, 0.1}, 0.5, 0.5));
  REQUIRE(contact);
  // The way out through the right face is 2 - 1.2 + 0.25, through the upper one 1 - 0.1 + 0.25.
  CHECK(contact->depth == near_relative(1.05, 1e-14));
  CHECK((contact->normal - Vec2{1, 0}).norm() <= 1e-14);
  CHECK((contact->point - Vec2{1.2, 0.1}).norm() <= 1e-14);
  CHECK(contact->chord == near_relative(0.5, 1e-14));
}

TEST_CASE("bodies that keep apart or only touch have no contact by separating axes") {
  const ConvexPolygon square = rectangle({0, 0}, 1, 1);
  CHECK(!contact_of(square, rectangle({1.0000001, 0.2}, 1, 1)));
  CHECK(!contact_of(square, rectangle({1, 0}, 1, 1)));
  CHECK(!contact_of(square, rectangle({1, 1}, 1, 1)));
  CHECK(!contact_of(square, rectangle({0.9, 0.9}, 1, 1, pi / 4)));
}

TEST_CASE("shifting the second body by the depth parts the two, and no shorter way does") {
  for_random_contacts<SeparatingAxis>(
      300, [](const auto& a, const auto& b, const ContactGeometry& contact) {
        const auto apart = [&](const Vec2& shift) { return !contact_of(a, shifted(b, shift)); };
        CHECK(apart((1 + 1e-9) * contact.depth * contact.normal));
        for (int degrees = 0; degrees < 360; degrees += 5) {
          const Vec2 direction = Rotation::from_angle(degrees * pi / 180) * Vec2{1, 0};
          CHECK(!apart((1 - 1e-6) * contact.depth * direction));
        }
      });
}

TEST_CASE("the chord is the rate at which the overlap changes along the normal") {
  // So that area_stiffness * area * chord is the slope of area_stiffness * area^2 / 2.
  int chords = 0;
  int gained = 0;
  for_random_contacts<SeparatingAxis>(
      1000, [&](const auto& a, const auto& b, const ContactGeometry& contact) {
        if (crossings(a, b) != 2) return;
        ++chords;
        const double slope = area_slope(a, b, contact.normal);
        // Areas end in digits of 1e-16, over 2e-6; they are quadratic in the shift unless a vertex
        // crosses a face meanwhile, which adds at most the shift.
        CHECK(std::abs(std::abs(slope) - contact.chord) <= 3e-6);
        gained += slope < 0;
      });
  CHECK(chords > 500);
  // Only bodies most of the way through each other overlap more when they begin to part.
  CHECK(gained < 0.01 * chords);
}

TEST_CASE("the depth lies between the overlap's least width and twice its area over the chord") {
  // Below: a strip as wide as the depth holds the overlap. Above, by Brunn and Minkowski: the root
  // of the area is concave along any shift, and along the normal of OverlapChord the area falls by
  // its chord, so that a shift by 2 area / chord parts the two.
  int chords = 0;
  for_random_contacts<SeparatingAxis>(
      2000, [&](const auto& a, const auto& b, const ContactGeometry& contact) {
        const double round_off = 1 + 1e-12;
        const OverlapPolygon common = overlap(a.ring(), b.ring(), a[0], 1e-10);
        CHECK(least_width(common.ring()) <= contact.depth * round_off);
        const ContactGeometry line = test::contact_of<OverlapChord>(a, b).value();
        // Clipped from either of the two: digits of 1e-16 all along a rim of a few metres.
        CHECK(contact.area == near(line.area, 1e-15));
        if (crossings(a, b) == 2) {
          ++chords;
          CHECK(contact.depth <= 2 * line.area / line.chord * round_off);
        } else {
          check_same(contact, line, 1e-14);
        }
      });
  CHECK(chords > 1000);
  CHECK(chords < 1950);
}

TEST_CASE("swapping the bodies turns the normal round and changes no other bit") {
  const auto check_swapped = [](const ConvexPolygon& a, const ConvexPolygon& b) {
    const auto contact = contact_of(a, b);
    auto swapped = contact_of(b, a);
    REQUIRE(contact.has_value() == swapped.has_value());
    if (!contact) return;
    swapped->normal = -swapped->normal;
    // Sums of +0 take the sign off a zero.
    swapped->normal += Vec2{0, 0};
    ContactGeometry expected = *contact;
    expected.normal += Vec2{0, 0};
    CHECK(same_bits(*swapped, expected));
  };
  test::for_random_pairs(500, check_swapped);
  // Rectangles on a lattice: equal depths on all sides.
  const ConvexPolygon fixed = rectangle({0, 0}, 2, 2);
  for (int size = 1; size <= 3; ++size)
    for (int x = -4; x <= 4; ++x)
      for (int y = -4; y <= 4; ++y) {
        if (size == 2 && x == 0 && y == 0) continue;  // its own mirror image has no normal
        check_swapped(fixed, rectangle({0.25 * x, 0.25 * y}, size, size));
      }
}

TEST_CASE("a contact by separating axes moves rigidly with its bodies, whatever their numbers") {
  test::check_contacts_move_rigidly<SeparatingAxis>();
}

TEST_CASE("the cache of a pair never changes its contact by separating axes") {
  for_random_contacts<SeparatingAxis>(
      100, [](const auto& a, const auto& b, const ContactGeometry& contact) {
        for (const bool of_b : {false, true})
          for (const unsigned edge : {0u, 1u, 2u, 7u, 255u}) {
            SeparatingAxis::Cache cache{of_b, static_cast<std::uint8_t>(edge)};
            const auto again = SeparatingAxis{}(a.ring(), b.ring(), cache);
            REQUIRE(again);
            CHECK(same_bits(*again, contact));
          }
      });
}
