// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/narrow_phase/contact_line.hpp>

#include <doctest/doctest.h>

#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using test::near_relative;
using test::rectangle;

namespace {

ContactGeometry line_of(const ConvexPolygon& a, const ConvexPolygon& b) {
  return contact_line(a.ring(), b.ring(), common_part(a.ring(), b.ring()));
}

}  // namespace

TEST_CASE("the contact line of two corners runs through the two points where they cross") {
  const ConvexPolygon a = rectangle({0, 0}, 2, 2);
  const ConvexPolygon b = rectangle({1.7, 1.6}, 2, 2);
  // Crossings at (0.7, 1) and (1, 0.6).
  const ContactGeometry line = line_of(a, b);
  CHECK(line.chord == near_relative(0.5, 1e-14));
  CHECK((line.point - Vec2{0.85, 0.8}).norm() <= 1e-15);
  CHECK((line.normal - Vec2{0.8, 0.6}).norm() <= 1e-14);
  CHECK((line_of(b, a).normal - Vec2{-0.8, -0.6}).norm() <= 1e-14);
}

TEST_CASE("without two proper crossings there is no contact line") {
  const ConvexPolygon a = rectangle({0, 0}, 2, 2);
  CHECK(line_of(a, rectangle({0.1, 0.2}, 1, 1)).chord == 0);   // inside
  CHECK(line_of(a, rectangle({0, 0.5}, 4, 0.1)).chord == 0);   // across, four crossings
  CHECK(line_of(a, rectangle({0.5, 1.4}, 1, 1)).chord == 0);   // flush at one end
  CHECK(line_of(a, rectangle({0, 1.999}, 2, 2)).chord == 0);   // flush at both ends
  CHECK(line_of(a, rectangle({0.4, 1.4}, 1, 1)).chord > 0.9);  // a face inside a face
}
