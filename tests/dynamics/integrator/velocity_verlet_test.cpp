// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <doctest/doctest.h>

#include <riprap/dynamics/integrator/velocity_verlet.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

constexpr double stiffness = 50;
constexpr double omega = 5;

Body oscillator() {
  Body body;
  body.position = {1, 0};
  body.mass = 2;
  body.inertia = 1;
  return body;
}

Wrench spring(const Body& body) { return {-stiffness * body.position, 0}; }

void step(Body& body, double time_step) {
  VelocityVerlet{}.advance(body, spring(body), time_step);
  VelocityVerlet{}.second_kick(body, spring(body), time_step);
}

struct Errors {
  double position = 0;
  double velocity = 0;
};

Errors errors_at_one(int steps) {
  Body body = oscillator();
  for (int i = 0; i < steps; ++i) step(body, 1.0 / steps);
  return {std::abs(body.position.x() - std::cos(omega)),
          std::abs(body.velocity.x() + omega * std::sin(omega))};
}

}  // namespace

TEST_CASE("velocity Verlet has the order it declares, in position and velocity") {
  const Errors coarse = errors_at_one(500);
  const Errors fine = errors_at_one(1000);
  // The next term of the expansion is (omega dt)^2 = 1e-4 smaller.
  CHECK(std::log2(coarse.position / fine.position) == near_relative(VelocityVerlet::order, 0.001));
  CHECK(std::log2(coarse.velocity / fine.velocity) == near_relative(VelocityVerlet::order, 0.001));
}

TEST_CASE("velocity Verlet follows a constant force exactly") {
  Body body = oscillator();
  body.position = {0, 0};
  const Wrench weight{{0, -2 * 9.81}, 0};
  for (int i = 0; i < 1000; ++i) {
    VelocityVerlet{}.advance(body, weight, 1e-3);
    VelocityVerlet{}.second_kick(body, weight, 1e-3);
  }
  // Round-off of 1000 additions.
  CHECK(body.position.y() == near_relative(-4.905, 1e-12));
  CHECK(body.velocity.y() == near_relative(-9.81, 1e-12));
}

TEST_CASE("velocity Verlet keeps energy within (omega dt)^2 / 4 for thousands of periods") {
  const double dt = 0.12 / omega;
  Body body = oscillator();
  for (int i = 0; i < 200000; ++i) {
    step(body, dt);
    const double energy = body.kinetic_energy() + 0.5 * stiffness * body.position.squaredNorm();
    REQUIRE(std::abs(energy / (0.5 * stiffness) - 1) <= 0.12 * 0.12 / 4 + 1e-10);
  }
}

TEST_CASE("velocity Verlet runs backwards to where it came from") {
  Body body = oscillator();
  body.velocity = {0.3, 0.7};
  const Body start = body;
  for (int i = 0; i < 1000; ++i) step(body, 0.12 / omega);
  for (int i = 0; i < 1000; ++i) step(body, -0.12 / omega);
  CHECK((body.position - start.position).norm() <= 1e-12);
  CHECK((body.velocity - start.velocity).norm() <= 1e-12 * omega);
}

TEST_CASE("velocity Verlet has a second kick to do") { CHECK(VelocityVerlet::has_second_kick); }
