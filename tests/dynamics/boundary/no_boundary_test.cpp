// SPDX-License-Identifier: BSL-1.0
#include <doctest/doctest.h>
#include <vector>

#include <riprap/dynamics/boundary/no_boundary.hpp>

using namespace riprap;

TEST_CASE("without a boundary every body keeps the velocity it was given") {
  std::vector<Body> bodies(3);
  bodies[0].motion = Motion::free;
  bodies[1].motion = Motion::prescribed;
  bodies[2].motion = Motion::strain_field;
  for (Body& body : bodies) {
    body.position = {3, 4};
    body.velocity = {1, 2};
  }
  NoBoundary{}.drive(bodies, 0.1);
  for (const Body& body : bodies) CHECK(body.velocity == Vec2{1, 2});
}
