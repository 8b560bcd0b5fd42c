// SPDX-License-Identifier: BSL-1.0
#include <riprap/geometry/chord_length.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

TEST_CASE("a line through the middle of a rectangle is cut off at its sides") {
  const ConvexPolygon slab = rectangle(0.04, 0.01);
  for (const Pose& pose : poses(0.04)) {
    const ConvexPolygon placed = pose.of(slab);
    const auto length = [&](const Vec2& through, double angle) {
      const Vec2 direction = pose.rotation * (Rotation::from_angle(angle) * Vec2{1, 0});
      return chord_length(placed.ring(), {pose.of(through), direction});
    };
    const double share = 1e-13 * pose.digits;
    CHECK(length({0, 0}, 0) == near_relative(0.04, share));
    CHECK(length({0, 0.002}, 0) == near_relative(0.04, share));
    CHECK(length({0.01, 0}, 0.5 * pi) == near_relative(0.01, share));
    CHECK(length({0, 0}, 0.7) == near_relative(0.01 / std::sin(0.7), share));
    CHECK(length({0, 0}, -2.4) == near_relative(0.01 / std::sin(2.4), share));
    CHECK(length({0, 0.02}, 0) == 0);
  }
}
