// SPDX-License-Identifier: BSL-1.0
#include <riprap/dynamics/body_force/uniform_body_force.hpp>

#include <doctest/doctest.h>

#include <limits>

using namespace riprap;

TEST_CASE("every body has the same acceleration, which must be finite") {
  const UniformBodyForce gravity{{0, -9.81}};
  Body body;
  CHECK(gravity(body) == Vec2{0, -9.81});
  body.mass = 5;
  body.position = {3, 4};
  CHECK(gravity(body) == Vec2{0, -9.81});
  CHECK_NOTHROW(gravity.validate());
  const UniformBodyForce broken{{0, std::numeric_limits<double>::infinity()}};
  CHECK_THROWS_WITH_AS(broken.validate(), "body force along axis 2 = inf: must be a finite number",
                       InvalidInput);
}
