// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/pair/contact.hpp>

#include <doctest/doctest.h>

using namespace riprap;

namespace {

struct Nothing {};

}  // namespace

TEST_CASE("the force on b pushes along the normal and shears along the tangent") {
  Contact<Nothing, Nothing> contact;
  contact.geometry.normal = {0, 1};  // the tangent is then {-1, 0}
  contact.force = {.normal = 3, .tangential = 2};
  CHECK(contact.force_on_b() == Vec2{-2, 3});
}

TEST_CASE("the branch leads from a to b") {
  Contact<Nothing, Nothing> contact;
  contact.arm_a = {1, 2};   // the contact is there from a
  contact.arm_b = {-3, 1};  // and there from b
  CHECK(contact.branch() == Vec2{4, 1});
}
