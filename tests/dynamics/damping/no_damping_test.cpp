// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>

#include <riprap/dynamics/damping/no_damping.hpp>

using namespace riprap;

TEST_CASE("without damping nothing is added, however fast a body moves") {
  Body body;
  body.velocity = {10, -20};
  body.angular_velocity = 5;
  const Wrench added = NoDamping{}(body, {{3, 4}, 5});
  CHECK(added.force == Vec2{0, 0});
  CHECK(added.moment == 0);
}
