// SPDX-License-Identifier: BSL-1.0
#include <riprap/simulation/external_loads.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include <riprap/breakage/criterion/mohr_coulomb.hpp>
#include <riprap/measurement/energy_ledger.hpp>
#include <support/crushing.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>
#include <support/unbreakable.hpp>

using namespace riprap;
using namespace riprap::test;

TEST_CASE("a constant force and moment accelerate a free body evenly, and their work is booked") {
  Simulation sim{undamped(springs(1e9, 0)),
                 of({{rectangle({0, 0}, 2, 1)}, {rectangle({5, 0}, 2, 1)}}), rock_of(2000)};
  EnergyLedger ledger;
  ledger.open(sim);
  const Vec2 force{3e3, -1e3};
  const double moment = 2e3;
  sim.set_load(1, force, moment);
  CHECK(sim.load_on(1).force == force);
  CHECK(sim.load_on(0).force == Vec2{0, 0});
  const double mass = 4000;
  const double inertia = mass * (4 + 1) / 12;
  constexpr int steps = 2000;
  for (int n = 0; n < steps; ++n) sim.step(ledger);
  const double t = sim.time();
  const Body& body = sim.particles().body(1);
  CHECK((body.velocity - t / mass * force).norm() <= 1e-12 * body.velocity.norm());
  CHECK(body.angular_velocity == near_relative(moment * t / inertia, 1e-12));
  // The scheme is of first order: n (n + 1) / 2 steps of way.
  const Vec2 way = 0.5 * t * t / mass * force;
  CHECK((body.position - Vec2{5, 0} - way).norm() <= 1.01 / steps * way.norm());
  CHECK(sim.work().load == near_relative(body.kinetic_energy(), 1e-12));
  CHECK(sim.particles().body(0).velocity == Vec2{0, 0});
  const EnergyTerms terms = ledger.terms(sim);
  CHECK(terms.load_work == sim.work().load);
  CHECK(std::abs(terms.unclosed()) <= 1e-12 * terms.load_work);

  sim.set_load(1, {0, 0});
  const Vec2 velocity = body.velocity;
  sim.step();
  CHECK(sim.particles().body(1).velocity == velocity);
}

TEST_CASE("a loaded block presses on what carries it") {
  Simulation sim{damped(springs(1e8, 0.5)),
                 of({{rectangle({0, -0.5}, 4, 1), Motion::wall}, {rectangle({0, 0.5}, 1, 1)}}),
                 rock_of(2000)};
  sim.set_load(1, {500, -3e3}, 100);
  for (int n = 0; n < 5000; ++n) sim.step();
  CHECK((sim.force_on(0).force - Vec2{500, -3e3}).norm() <= 1e-6 * 3e3);
  CHECK(sim.force_on(1).moment == near(-100, 1e-3));
  CHECK(sim.particles().body(1).velocity.norm() <= 1e-9);
  // A body that is held does not feel it.
  sim.set_load(0, {0, 1e6});
  sim.step();
  CHECK(sim.particles().body(0).velocity == Vec2{0, 0});
}

TEST_CASE("a load stays with its body when another is removed, and ends when its own breaks") {
  Assembly assembly = square_between_platens(0.5);
  assembly.particles.insert(assembly.particles.begin(),
                            PlacedParticle{rectangle({0.2, 0}, 0.01, 0.02)});
  Simulation sim{Model{}.boundary(NoBoundary{}).criterion(MohrCoulomb{}), assembly, Rock{}};
  sim.set_load(0, {7, 0});
  sim.set_load(1, {1, 2}, 3e-3);
  sim.remove(0);
  CHECK(sim.load_on(1).force == Vec2{1, 2});
  CHECK(sim.load_on(1).moment == 3e-3);
  CHECK(sim.load_on(2).force == Vec2{0, 0});
  for (int n = 0; n < 400 && sim.breaks().empty(); ++n) sim.step();
  REQUIRE(sim.breaks().size() == 1);
  for (const ParticleId piece : sim.breaks()[0].pieces)
    CHECK(sim.load_on(piece).force == Vec2{0, 0});
  CHECK_THROWS_WITH_AS(sim.set_load(1, {1, 0}),
                       "particle 1: must be in the simulation; it has broken or was removed",
                       InvalidInput);
  CHECK_THROWS_WITH_AS(sim.set_load(2, {std::numeric_limits<double>::infinity(), 0}),
                       "particle 2: load (inf, 0) N, 0 N m: must be finite", InvalidInput);
}
