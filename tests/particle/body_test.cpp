// SPDX-License-Identifier: BSL-1.0
#include <riprap/particle/body.hpp>

#include <doctest/doctest.h>

#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

TEST_CASE("a new body is at rest, free, unturned and not scaled") {
  const Body body;
  CHECK(body.is_free());
  CHECK(body.velocity.norm() == 0);
  CHECK(body.angular_velocity == 0);
  CHECK(body.rotation.angle() == 0);
  CHECK(body.mass_scaling == 1);
  CHECK(body.contact.force.norm() == 0);
  CHECK(body.contact.moment == 0);
}

TEST_CASE("only a free body follows Newton's law") {
  Body body;
  body.motion = Motion::prescribed;
  CHECK_FALSE(body.is_free());
  body.motion = Motion::strain_field;
  CHECK_FALSE(body.is_free());
}

TEST_CASE("kinetic energy is that of translation and rotation, with the scaled mass") {
  Body body;
  body.mass = 2;
  body.inertia = 0.5;
  body.velocity = {3, -4};
  body.angular_velocity = -6;
  // 2 * 25 / 2 + 0.5 * 36 / 2.
  CHECK(body.kinetic_energy() == 34);
  body.mass_scaling = 1.5;
  CHECK(body.kinetic_energy() == 51);
}

TEST_CASE("a point of a turning body moves across its arm") {
  Body body;
  body.velocity = {1, 2};
  body.angular_velocity = 10;
  const Vec2 v = body.velocity_at({0.1, 0.3});
  CHECK(v.x() == near_relative(1 - 3, 1e-15));
  CHECK(v.y() == near_relative(2 + 1, 1e-15));
  CHECK(body.velocity_at({0, 0}) == body.velocity);
}

TEST_CASE("energy of the points of a rod is that of the body") {
  // Two point masses at +-arm: m |v|^2 / 2 + I w^2 / 2 is the sum over the points.
  const Vec2 arm{0.3, -0.4};
  Body body;
  body.mass = 2 * 1.5;
  body.inertia = 2 * 1.5 * arm.squaredNorm();
  body.velocity = {0.7, 0.2};
  body.angular_velocity = 3;
  const double points =
      0.5 * 1.5 * (body.velocity_at(arm).squaredNorm() + body.velocity_at(-arm).squaredNorm());
  CHECK(body.kinetic_energy() == near_relative(points, 1e-15));
}
