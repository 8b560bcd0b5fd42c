// SPDX-License-Identifier: BSL-1.0
#include <riprap/dynamics/body_force/concepts.hpp>

#include <doctest/doctest.h>

using namespace riprap;

TEST_CASE("a body force is a function of a body, lambdas included") {
  const auto centrifuge = [](const Body& body) -> Vec2 { return 4 * body.position; };
  const auto of_nothing = []() -> Vec2 { return {0, 0}; };
  CHECK(BodyForce<decltype(centrifuge)>);
  CHECK_FALSE(BodyForce<decltype(of_nothing)>);
  CHECK_FALSE(BodyForce<int>);
}
