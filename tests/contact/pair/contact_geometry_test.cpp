// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/contact/pair/contact_geometry.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

TEST_CASE("the tangent of a contact is its normal turned by +90 degrees") {
  ContactGeometry contact;
  contact.normal = {0.6, 0.8};
  CHECK(contact.tangent() == Vec2{-0.8, 0.6});
  CHECK(cross(contact.normal, contact.tangent()) == near_relative(1, 1e-15));
}
