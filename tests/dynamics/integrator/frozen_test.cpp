// SPDX-License-Identifier: BSL-1.0
#include <riprap/dynamics/integrator/frozen.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/measurement/energy_ledger.hpp>
#include <support/crushing.hpp>
#include <support/near.hpp>
#include <support/unbreakable.hpp>

using namespace riprap;

namespace {

/// Error at time 1 of a mass on a spring that begins at x = 1 and should swing as cos 5 t.
double error_at_one(int steps) {
  Body body;
  body.position = {1, 0};
  body.mass = 2;
  body.inertia = 1;
  for (int i = 0; i < steps; ++i) {
    Frozen{}.advance(body, {-50 * body.position, 0}, 1.0 / steps);
    Frozen{}.second_kick(body, {-50 * body.position, 0}, 1.0 / steps);
  }
  return std::abs(body.position.x() - std::cos(5));
}

}  // namespace

TEST_CASE("no time step brings frozen bodies nearer to where they should be: order 0") {
  CHECK(std::log2(error_at_one(100) / error_at_one(200)) == Frozen::order);
  CHECK(error_at_one(100) > 0.1);
}

TEST_CASE("a frozen body is at rest where it was") {
  Body body;
  body.position = {1, 2};
  body.rotation = Rotation::from_angle(0.3);
  body.velocity = {3, -4};
  body.angular_velocity = 5;
  body.mass = body.inertia = 1;
  Frozen{}.advance(body, {{1e6, 1e6}, 1e6}, 1);
  CHECK(body.position == Vec2{1, 2});
  CHECK(body.rotation.sine == std::sin(0.3));
  CHECK(body.velocity == Vec2{0, 0});
  CHECK(body.angular_velocity == 0);
}

TEST_CASE("driven bodies press on frozen ones: all their work is stored") {
  Simulation sim{test::damped(LinearSpringCoulomb{}).integrator(Frozen{}),
                 test::square_between_platens(0.2), Rock{}};
  EnergyLedger ledger;
  ledger.open(sim);
  for (int i = 0; i < 1000; ++i) sim.step(ledger);
  CHECK(sim.particles().body(0).position == Vec2{0, 0});
  // Two springs of k = 2e7 N/m, each closed at 0.2 m/s.
  const double depth = 0.2 * sim.time();
  const EnergyTerms terms = ledger.terms(sim);
  CHECK(terms.stored == test::near_relative(2e7 * depth * depth, 1e-11));
  // The work of each of 1000 steps is booked with the force that the step began with.
  CHECK(terms.boundary_work == test::near_relative(terms.stored * (1 - 1e-3), 1e-11));
  CHECK(terms.kinetic == 0);
  CHECK(terms.damping == 0);
}
