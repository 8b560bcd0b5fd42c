// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <doctest/doctest.h>
#include <string>

#include <riprap/dynamics/damping/viscous_damping.hpp>
#include <riprap/dynamics/integrator/concepts.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

TEST_CASE("viscous damping lets every velocity decay as exp(-rate t), whatever the mass") {
  const ViscousDamping damping{.rate = 100};
  for (const double mass : {0.01, 3.0})
    for (const double scaling : {1.0, 7.0}) {
      Body body;
      body.velocity = {3, -4};
      body.angular_velocity = 5;
      body.mass = mass;
      body.inertia = 0.1 * mass;
      body.mass_scaling = scaling;
      const double dt = 1e-6;
      for (int i = 0; i < 10000; ++i) kick(body, damping(body, {{1, 2}, 3}), dt);
      // After 0.01 s: exp(-1). The explicit step is off by rate^2 t dt / 2 = 5e-5 of it.
      CHECK((body.velocity - std::exp(-1) * Vec2{3, -4}).norm() <= 5 * std::exp(-1) * 6e-5);
      CHECK(body.angular_velocity == near_relative(5 * std::exp(-1), 6e-5));
    }
}

TEST_CASE("viscous damping does nothing to a body at rest, whatever pushes it") {
  Body body;
  body.mass = 1;
  const Wrench added = ViscousDamping{}(body, {{1, 2}, 3});
  CHECK(added.force.norm() == 0);
  CHECK(added.moment == 0);
}

TEST_CASE("a negative rate of viscous damping is refused by name") {
  std::string message;
  try {
    ViscousDamping{.rate = -1}.validate();
  } catch (const InvalidInput& error) {
    message = error.what();
  }
  CHECK(message == "ViscousDamping.rate = -1: must be a finite number, 0 or above");
  CHECK_NOTHROW(ViscousDamping{.rate = 0}.validate());
}
