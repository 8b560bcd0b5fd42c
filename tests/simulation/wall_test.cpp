// SPDX-License-Identifier: BSL-1.0
// Walls with friction: a slope, a belt, a box and a wall that turns.

#include <cmath>
#include <doctest/doctest.h>
#include <numbers>

#include <riprap/dynamics/boundary/rigid_platens.hpp>
#include <riprap/measurement/average_stress.hpp>
#include <riprap/measurement/energy_ledger.hpp>
#include <riprap/measurement/fabric.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>
#include <support/unbreakable.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double gravity = 9.81;

/// A block of 10 m x 2 m on a wall below it, sunk in by `depth`; its sides lean so that a reaction
/// in the middle of its base that leans as much passes through its centroid.
Assembly block_on_slope(double slope, double lean, double depth, double speed = 0) {
  const double shift = -2 * lean;
  const ConvexPolygon block{
      {-5, -depth}, {5, -depth}, {5 + shift, 2 - depth}, {-5 + shift, 2 - depth}};
  const Rotation turn = Rotation::from_angle(-slope);
  return of({{rectangle({20, -1}, 100, 2).moved(turn, {0, 0}), Motion::wall},
             {block.moved(turn, {0, 0}), Motion::free, turn * Vec2{speed, 0}}});
}

}  // namespace

TEST_CASE("a block slides down a rough wall with g (sin psi - mu cos psi)") {
  const double slope = 30 * degree;
  const double k = 1e10;
  const double normal = 20 * 2000 * gravity * std::cos(slope);
  const Rotation turn = Rotation::from_angle(-slope);
  for (const double friction : {0.0, 0.3, 0.55}) {
    CAPTURE(friction);
    Simulation sim{undamped(springs(k, friction)), block_on_slope(slope, friction, normal / k, 1),
                   rock_of(2000)};
    sim.set_body_force({0, -gravity});
    // In the first step there is no friction yet; the spin it leaves is taken away.
    sim.step();
    sim.set_velocity(1, sim.particles().body(1).velocity);
    EnergyLedger ledger;
    ledger.open(sim);
    const Body start = sim.particles().body(1);
    const double begin = sim.time();
    while (sim.time() < 1) sim.step(ledger);
    const Vec2 gained = turn.inverse_times(sim.particles().body(1).velocity - start.velocity);
    // The contact swings about the depth of 3e-5 m that it starts from; forces swing the most.
    CHECK(gained.x() / (sim.time() - begin) ==
          near_relative(gravity * (std::sin(slope) - friction * std::cos(slope)), 1e-3));
    const EnergyTerms terms = ledger.terms(sim);
    CHECK(std::abs(terms.unclosed()) <= 1e-3 * terms.body_force_work);
    // The wall carries what the block presses and rubs with.
    CHECK((sim.force_on(0).force + sim.force_on(1).force).norm() == near(0, 1e-12 * normal));
    const Vec2 on_wall = turn.inverse_times(sim.force_on(0).force);
    CHECK(on_wall.y() == near_relative(-normal, 5e-3));
    CHECK(on_wall.x() == near(friction * normal, 5e-3 * normal));
  }
}

TEST_CASE("a block rests on a rough wall that is less steep than its friction, not on a platen") {
  const double slope = 20 * degree;
  for (const Motion motion : {Motion::wall, Motion::platen}) {
    Assembly assembly = block_on_slope(slope, std::tan(slope), 0);
    assembly.particles[0].motion = motion;
    Simulation sim{damped(springs(1e8, std::tan(25 * degree))), assembly, rock_of(2000)};
    sim.set_body_force({0, -gravity});
    for (int i = 0; i < 3000; ++i) sim.step();
    const Body& block = sim.particles().body(1);
    if (motion == Motion::wall) {
      CHECK((block.contact.force - Vec2{0, block.mass * gravity}).norm() <=
            1e-6 * block.mass * gravity);
      CHECK(block.velocity.norm() <= 1e-6);
    } else {
      CHECK(block.velocity.norm() > 0.1);
    }
  }
}

TEST_CASE("the moment on a wall is that of the contact force about its centroid") {
  // 10 m x 2 m on one end of a wall of 40 m, in balance: its weight at 15 m from the middle.
  Simulation sim{
      undamped(springs(1e9, 0.5)),
      of({{rectangle({0, -1}, 40, 2), Motion::wall}, {rectangle({15, 1 - 4e-4}, 10, 2)}}),
      rock_of(2000)};
  const double force = 1e9 * 4e-4;
  CHECK((sim.force_on(0).force - Vec2{0, -force}).norm() == near(0, 1e-6 * force));
  CHECK(sim.force_on(0).moment == near_relative(-15 * force, 1e-9));
  CHECK(sim.force_on(1).moment == near(0, 1e-6 * force));
  CHECK_THROWS_WITH_AS((void)sim.force_on(2), "body = 2: must be in the simulation", InvalidInput);
}

TEST_CASE("a belt carries a block along at mu g until it has the belt's speed") {
  const double friction = 0.2;
  const double k = 1e9;
  const double depth = 20 * 2000 * gravity / k;
  Simulation sim{undamped(springs(k, friction)), block_on_slope(0, -friction, depth),
                 rock_of(2000)};
  sim.set_body_force({0, -gravity});
  EnergyLedger ledger;
  ledger.open(sim);
  const double belt = 0.5;
  sim.set_velocity(0, {belt, 0});
  const double catches_up = belt / (friction * gravity);
  while (sim.time() < 0.8 * catches_up) sim.step(ledger);
  const Body& block = sim.particles().body(1);
  CHECK(block.velocity.x() == near_relative(0.8 * belt, 0.01));
  while (sim.time() < 1.3 * catches_up) sim.step(ledger);
  CHECK(block.velocity.x() == near_relative(belt, 0.01));
  // The belt does the work of the friction over its own way: that of the slip and the block's.
  const EnergyTerms terms = ledger.terms(sim);
  const double gained = 0.5 * block.mass * belt * belt;
  CHECK(terms.boundary_work == near_relative(2 * gained, 0.02));
  CHECK(terms.slip == near_relative(gained, 0.02));
  CHECK(std::abs(terms.unclosed()) <= 1e-3 * gained);
}

TEST_CASE("a wall turns about the point that it is given") {
  Simulation sim{undamped(springs(1e6, 0)),
                 of({{rectangle({0, 0}, 4, 2), Motion::wall}, {rectangle({0, 20}, 1, 1)}}),
                 rock_of(2000)};
  const Vec2 hinge{-2, -1};
  const double spin = 0.3;
  const Vec2 start = sim.particles().body(0).position;
  // Steps of 1.6e-3 rad: each turns by its angle to the third order, of which a twelfth is off, and
  // moves the centroid along the tangent.
  for (int n = 0; n < 1000; ++n) {
    sim.set_velocity_about(0, hinge, {0, 0}, spin);
    sim.step();
  }
  const double angle = spin * sim.time();
  const Vec2 turned = hinge + Rotation::from_angle(angle) * (start - hinge);
  CHECK(sim.particles().body(0).rotation.angle() == near_relative(angle, 3e-7));
  CHECK((sim.particles().body(0).position - turned).norm() <=
        0.51 * angle * spin * sim.time_step() * (start - hinge).norm());
  sim.set_velocity_about(0, hinge, {1, 2}, 0);
  CHECK(sim.particles().body(0).velocity == Vec2{1, 2});
}

TEST_CASE("stress between walls is force over length, wherever their centroids are") {
  // A square of 1 m, 1e-4 m deep in four walls of different thickness.
  for (const Motion motion : {Motion::wall, Motion::platen}) {
    const auto side = [&](const Vec2& towards, double thickness) -> PlacedParticle {
      const Vec2 centre = (0.5 - 1e-4 + 0.5 * thickness) * towards;
      return {towards.x() != 0 ? rectangle(centre, thickness, 5) : rectangle(centre, 5, thickness),
              motion};
    };
    Simulation sim{undamped(springs(1e8, 0.5)),
                   of({{rectangle({0, 0}, 1, 1)},
                       side({1, 0}, 1),
                       side({-1, 0}, 0.3),
                       side({0, 1}, 2),
                       side({0, -1}, 0.7)}),
                   rock_of(2000)};
    const Stress2 stress = average_stress(sim.contacts(), 1, 1);
    CHECK(stress.s11 == near_relative(1e8 * 1e-4, 1e-3));  // branches are shorter by the depth
    CHECK(stress.s22 == near_relative(1e8 * 1e-4, 1e-3));
    const Ellipse inner{.semi_axes = {0.3, 0.3}};
    CHECK(average_stress_within(sim.contacts(), inner, 1).s11 ==
          near_relative(1e8 * 1e-4 * 0.6 / inner.area(), 1e-3));
    CHECK(contact_samples(sim.contacts()).empty());
  }
}

TEST_CASE("rough walls that close in on a sample hold it by friction, platens do not") {
  // A tall block between side walls that move up together with the lid: only rough ones lift it.
  for (const Motion motion : {Motion::wall, Motion::platen}) {
    Simulation sim{damped(springs(1e8, 0.5)),
                   of({{rectangle({0, 0}, 1, 1)},
                       {rectangle({1 - 1e-4, 0}, 1, 5), motion},
                       {rectangle({-1 + 1e-4, 0}, 1, 5), motion}}),
                   rock_of(2000)};
    sim.set_velocity(1, {0, 0.01});
    sim.set_velocity(2, {0, 0.01});
    for (int n = 0; n < 2000; ++n) sim.step();
    const double way = 0.01 * sim.time();
    CHECK(sim.particles().body(0).position.y() ==
          near(motion == Motion::wall ? way : 0, 0.05 * way));
  }
}
