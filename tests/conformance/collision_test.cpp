// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

#include <riprap/conformance/collision.hpp>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

TEST_CASE("a collision goes in to the deepest point and out again, as its velocities say") {
  const ContactRange range{.deepest = 2e-4};
  for (const bool corner : {false, true}) {
    double depth = 0;
    double deepest = 0;
    double slide = 0;
    double farthest = 0;
    double time = 0;
    internal::visit_collision(range, corner, 1e-4, [&](const internal::CollisionInstant& now) {
      depth -= now.motion.normal_velocity * now.motion.time_step;
      slide += now.motion.tangential_velocity * now.motion.time_step;
      time += now.motion.time_step;
      const double way = now.geometry.depth / now.geometry.depth_gradient;
      deepest = std::max(deepest, way);
      farthest = std::max(farthest, std::abs(slide));
      REQUIRE(std::abs(depth - way) <= 1e-12 * range.deepest);
    });
    // Round-off of some thousand additions.
    CHECK(deepest == near_relative(2e-4, 1e-12));
    CHECK(std::abs(depth) <= 1e-12 * range.deepest);
    CHECK(farthest == near_relative(3 * 2e-4, 1e-3));
    CHECK(time == near_relative(1e-4, 1e-12));
  }
}

TEST_CASE("the overlap of a collision grows by its chord times the depth") {
  for (const bool corner : {false, true}) {
    const ContactGeometry at = internal::contact_of({}, corner, 5e-5);
    const ContactGeometry deeper = internal::contact_of({}, corner, 5.2e-5);
    CHECK(deeper.area - at.area == near_relative(2e-6 * 0.5 * (at.chord + deeper.chord), 1e-12));
    CHECK(at.normal.norm() == near_relative(1, 1e-15));
  }
}

TEST_CASE("a collision lasts half a period of the stiffest spring") {
  const LinearSpringCoulomb law{.normal_stiffness = 4e6, .tangential_stiffness = 1e6};
  CHECK(internal::collision_time(law, {.effective_mass = 1}) ==
        near_relative(std::numbers::pi / 2e3, 1e-15));
}
