// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <doctest/doctest.h>
#include <vector>

#include <riprap/dynamics/boundary/strain_field.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

Body at(const Vec2& position, Motion motion) {
  Body body;
  body.position = position;
  body.velocity = {7, 8};
  body.angular_velocity = 9;
  body.motion = motion;
  return body;
}

}  // namespace

TEST_CASE("a strain field drives the bodies of the field and no others") {
  std::vector<Body> bodies{at({2, 3}, Motion::strain_field), at({2, 3}, Motion::free),
                           at({2, 3}, Motion::prescribed), at({-4, 5}, Motion::strain_field)};
  StrainField field;
  field.set_rate(0.1, -0.2);
  field.drive(bodies, 0.01);
  // Shortening along axis 1, extension along axis 2.
  CHECK((bodies[0].velocity - Vec2{-0.2, 0.6}).norm() <= 1e-15);
  CHECK((bodies[3].velocity - Vec2{0.4, 1.0}).norm() <= 1e-15);
  for (const std::size_t other : {1u, 2u}) {
    CHECK(bodies[other].velocity == Vec2{7, 8});
    CHECK(bodies[other].angular_velocity == 9);
  }
}

TEST_CASE("a strain field that has not been set holds its bodies") {
  std::vector<Body> bodies{at({2, 3}, Motion::strain_field)};
  StrainField field;
  CHECK(field.rate() == Vec2{0, 0});
  field.drive(bodies, 0.01);
  CHECK(bodies[0].velocity.norm() == 0);
}

TEST_CASE("bodies of a strain field stay in one homogeneous deformation") {
  std::vector<Body> bodies{at({2, 3}, Motion::strain_field), at({-1, 0.5}, Motion::strain_field)};
  StrainField field;
  field.set_rate(0.3, 0.7);
  const double dt = 1e-4;
  for (int i = 0; i < 10000; ++i) {
    field.drive(bodies, dt);
    for (Body& body : bodies) body.position += dt * body.velocity;
  }
  // x = x0 exp(-rate t); the explicit step is off by rate^2 t dt / 2 of it.
  const Vec2 stretch{std::exp(-0.3), std::exp(-0.7)};
  CHECK((bodies[0].position - stretch.cwiseProduct(Vec2{2, 3})).norm() <= 3 * 0.7 * 0.7 * dt);
  CHECK((bodies[1].position - stretch.cwiseProduct(Vec2{-1, 0.5})).norm() <= 0.7 * 0.7 * dt);
  // Ratios stay, to the round-off of 10000 steps: the deformation is homogeneous whatever the step.
  CHECK(bodies[0].position.x() / bodies[1].position.x() == near_relative(-2, 1e-12));
  CHECK(bodies[0].position.y() / bodies[1].position.y() == near_relative(6, 1e-12));
}
