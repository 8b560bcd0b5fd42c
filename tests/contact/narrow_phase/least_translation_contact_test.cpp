// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/narrow_phase/least_translation_contact.hpp>

#include <doctest/doctest.h>

#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using test::near_relative;
using test::rectangle;

TEST_CASE("the least translation leads across the face, the chord along it") {
  const ConvexPolygon a = rectangle({0, 0}, 3, 2);
  const ConvexPolygon b = rectangle({0.5, 1.4}, 1, 1);
  const ContactGeometry contact =
      least_translation_contact(a.ring(), b.ring(), common_part(a.ring(), b.ring()));
  CHECK((contact.normal - Vec2{0, 1}).norm() <= 1e-15);
  CHECK(contact.depth == near_relative(0.1, 1e-14));
  CHECK(contact.chord == near_relative(1, 1e-15));
  CHECK(contact.area == near_relative(0.1, 1e-14));
  CHECK((contact.point - Vec2{0.5, 0.95}).norm() <= 1e-15);
}
