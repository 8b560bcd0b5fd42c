// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>

#include <riprap/dynamics/integrator/symplectic_euler.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near_relative;

namespace {

constexpr double mass = 2;
constexpr double stiffness = 50;  // so that omega = 5
constexpr double omega = 5;

/// A mass on a spring at x = 1 and at rest.
Body oscillator() {
  Body body;
  body.position = {1, 0};
  body.mass = mass;
  body.inertia = 1;
  return body;
}

void advance(Body& body, double time_step) {
  SymplecticEuler{}.advance(body, {-stiffness * body.position, 0}, time_step);
}

double energy(const Body& body) {
  return body.kinetic_energy() + 0.5 * stiffness * body.position.squaredNorm();
}

/// Error of the position at time 1 with velocities as they stand, or half a step early.
double error_at_one(int steps, bool half_step_early) {
  const double dt = 1.0 / steps;
  Body body = oscillator();
  if (half_step_early) body.velocity.x() = 0.5 * dt * omega * omega;
  for (int i = 0; i < steps; ++i) advance(body, dt);
  return std::abs(body.position.x() - std::cos(omega));
}

}  // namespace

TEST_CASE("symplectic Euler has the order it declares") {
  const double order = std::log2(error_at_one(2000, false) / error_at_one(4000, false));
  // The next term of the expansion is omega dt = 2.5e-3 smaller.
  CHECK(order == near_relative(SymplecticEuler::order, 0.01));
}

TEST_CASE("with velocities read as half a step early it is leapfrog, of second order") {
  const double order = std::log2(error_at_one(500, true) / error_at_one(1000, true));
  // The next term of the expansion is (omega dt)^2 = 1e-4 smaller.
  CHECK(order == near_relative(2, 0.001));
}

TEST_CASE("the energy of an oscillator swings within bounds and never drifts") {
  const double dt = 0.12 / omega;
  Body body = oscillator();
  const double start = energy(body);
  double low = start;
  double high = start;
  // A kick and a drift keep 1/2 m v^2 + 1/2 k x^2 - 1/2 k dt x v exactly.
  const auto conserved = [dt](const Body& b) {
    return energy(b) - 0.5 * dt * stiffness * b.position.dot(b.velocity);
  };
  const double kept = conserved(body);
  for (int i = 0; i < 200000; ++i) {
    advance(body, dt);
    low = std::min(low, energy(body));
    high = std::max(high, energy(body));
  }
  // The swing is +-(omega dt)/2 of the energy, to first order, after 4000 periods as in the first.
  CHECK(high <= start * (1 + 0.12));
  CHECK(low >= start * (1 - 0.12));
  CHECK(high - low > 0.05 * start);  // the bound is not an idle one
  // Round-off of 200000 steps.
  CHECK(std::abs(conserved(body) - kept) <= 1e-11 * start);
}

TEST_CASE("the map of one step keeps areas of phase space") {
  const double dt = 0.3 / omega;
  // The map is linear in (x, v): its columns are the images of the unit states.
  Body x_state = oscillator();
  Body v_state = oscillator();
  v_state.position = {0, 0};
  v_state.velocity = {1, 0};
  advance(x_state, dt);
  advance(v_state, dt);
  const double determinant =
      x_state.position.x() * v_state.velocity.x() - v_state.position.x() * x_state.velocity.x();
  CHECK(determinant == near_relative(1, 1e-14));
}

TEST_CASE("leapfrog runs backwards to where it came from") {
  const double dt = 0.12 / omega;
  Body body = oscillator();
  body.velocity = {0.3, 0.7};
  const Body start = body;
  for (int i = 0; i < 1000; ++i) advance(body, dt);
  // Backwards in time drift comes first; negative steps of drift and kick undo the scheme.
  for (int i = 0; i < 1000; ++i) {
    drift(body, -dt);
    kick(body, {-stiffness * body.position, 0}, -dt);
  }
  CHECK((body.position - start.position).norm() <= 1e-12);
  CHECK((body.velocity - start.velocity).norm() <= 1e-12 * omega);
}

TEST_CASE("a torque spring turns a body at its own frequency") {
  const double inertia = 0.5;
  Body body = oscillator();
  body.inertia = inertia;
  body.rotation = Rotation::from_angle(0.01);
  const double torsion = inertia * omega * omega;
  const int steps = 2000;
  const double dt = 1.0 / steps;
  body.angular_velocity = 0.5 * dt * omega * omega * 0.01;  // half a step early
  for (int i = 0; i < steps; ++i)
    SymplecticEuler{}.advance(body, {{0, 0}, -torsion * body.rotation.angle()}, dt);
  // (omega dt)^2 / 24 of phase, 5 rad: 1e-6.
  CHECK(std::abs(body.rotation.angle() - 0.01 * std::cos(omega)) <= 0.01 * 2e-6);
}

TEST_CASE("symplectic Euler has no second kick") {
  CHECK(!SymplecticEuler::has_second_kick);
  Body body = oscillator();
  SymplecticEuler{}.second_kick(body, {{1, 2}, 3}, 0.1);
  CHECK(body.velocity == Vec2{0, 0});
  CHECK(body.position == Vec2{1, 0});
}
