// SPDX-License-Identifier: BSL-1.0
#include <riprap/simulation/body_changes.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include <riprap/breakage/criterion/mohr_coulomb.hpp>
#include <riprap/core/random.hpp>
#include <riprap/geometry/random_polygon.hpp>
#include <riprap/measurement/energy_ledger.hpp>
#include <support/crushing.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>
#include <support/same_run.hpp>
#include <support/unbreakable.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

// State of the bodies whose ids are below `end`, in their order.
template <class Sim>
std::vector<double> numbers_of(const Sim& sim, ParticleId end) {
  std::vector<double> numbers;
  for (BodyIndex i = 0; i < sim.particles().size(); ++i) {
    if (sim.particles().ancestry(i).id >= end) continue;
    const Body& b = sim.particles().body(i);
    for (const double x :
         {b.position.x(), b.position.y(), b.rotation.sine, b.velocity.x(), b.velocity.y(),
          b.angular_velocity, b.contact.force.x(), b.contact.force.y(), b.contact.moment})
      numbers.push_back(x);
  }
  return numbers;
}

// Three blocks on a slope, in contact with it and with friction.
template <class ModelType>
auto blocks(const ModelType& model) {
  const Rotation tilt = Rotation::from_angle(-0.3);
  const auto block = [&](double x) -> PlacedParticle {
    return {rectangle({x, 0.00799}, 0.016, 0.016).moved(tilt, {0, 0})};
  };
  Simulation sim{model,
                 Assembly{.particles = {block(-0.03),
                                        {rectangle({0, -0.01}, 0.2, 0.02).moved(tilt, {0, 0}),
                                         Motion::prescribed},
                                        block(0),
                                        block(0.03)}},
                 Rock{}};
  sim.set_body_force({0, -9.81});
  return sim;
}

auto model() { return Model{}.boundary(NoBoundary{}); }

}  // namespace

TEST_CASE("a body that is added and removed again leaves the others as they were, to the byte") {
  const auto run = [](const auto& with, bool changes) {
    auto sim = blocks(with);
    for (int n = 0; n < 600; ++n) {
      if (changes && n % 200 == 100) {
        // One that touches nothing, and one that lies in the first block, which is moving.
        const Vec2 at = sim.particles().body(0).position;
        const ParticleId far = sim.add(rectangle({0.5, 0.5}, 0.02, 0.02));
        const ParticleId near_by = sim.add(rectangle(at + Vec2{-0.012, 0.006}, 0.012, 0.03));
        CHECK(near_by == far + 1);
        CHECK(sim.force_on(sim.index_of(near_by)).force.norm() > 0);
        sim.remove(far);
        sim.remove(near_by);
      }
      sim.step();
    }
    return numbers_of(sim, 4);
  };
  const auto expected = run(model(), false);
  CHECK(same_bytes(run(model(), true), expected));
  CHECK(same_bytes(run(model().without_acceleration(), true), expected));
}

TEST_CASE("contacts of the others keep their histories when a body before them is removed") {
  auto sim = blocks(model());
  // While the blocks rebound from the depth that they start at.
  for (int n = 0; n < 5; ++n) sim.step();
  const auto tangential = [&](ParticleId id) {
    double force = 0;
    sim.contacts().for_each_touching([&](const auto& c) {
      if (c.a == sim.index_of(id) || c.b == sim.index_of(id)) force = c.history.tangential_force;
    });
    return force;
  };
  const double second = tangential(2);
  const double third = tangential(3);
  REQUIRE(std::abs(second) > 0);
  const Vec2 floor = sim.force_on(1).force;
  const Vec2 carried = sim.force_on(0).force;
  sim.remove(0);
  CHECK(sim.particles().size() == 3);
  CHECK(sim.index_of(1) == 0);
  CHECK(sim.index_of(3) == 2);
  CHECK(tangential(2) == second);
  CHECK(tangential(3) == third);
  CHECK((sim.force_on(0).force - (floor + carried)).norm() == near(0, 1e-12 * floor.norm()));
}

TEST_CASE("ids are not used again, and what cannot be is refused without a trace") {
  auto sim = blocks(model());
  const auto before = numbers_of(sim, 4);
  const double dt = sim.time_step();
  const ParticleId first = sim.add(rectangle({0.5, 0}, 0.02, 0.02), Motion::free, {1, 2}, 3);
  CHECK(first == 4);
  CHECK(sim.particles().body(sim.index_of(first)).velocity == Vec2{1, 2});
  CHECK(sim.particles().body(sim.index_of(first)).angular_velocity == 3);
  sim.remove(first);
  CHECK(sim.add(rectangle({0.5, 0}, 0.02, 0.02)) == 5);
  CHECK_THROWS_WITH_AS(sim.remove(4),
                       "particle 4: must be in the simulation; it has broken or was removed",
                       InvalidInput);
  CHECK_THROWS_WITH_AS((void)sim.index_of(4),
                       "particle 4: must be in the simulation; it has broken or was removed",
                       InvalidInput);
  sim.remove(5);
  // Right in another one.
  const Vec2 at = sim.particles().body(2).position;
  CHECK_THROWS_AS(sim.add(rectangle(at, 0.014, 0.014)), InvalidInput);
  CHECK_THROWS_AS(sim.add(rectangle({0.5, 0}, 0.02, 0.02), Motion::free, {std::nan(""), 0}),
                  InvalidInput);
  CHECK(sim.particles().size() == 4);
  CHECK(same_bytes(numbers_of(sim, 4), before));
  CHECK(sim.time_step() == dt);
  // A quarter of the mass needs half of the step, which stays.
  const ParticleId light = sim.add(rectangle({0.5, 0}, 0.008, 0.008));
  CHECK(sim.time_step() == near_relative(0.5 * dt, 1e-12));
  sim.remove(light);
  CHECK(sim.time_step() == near_relative(0.5 * dt, 1e-12));
  for (const ParticleId id : {0u, 1u, 2u}) sim.remove(id);
  CHECK_THROWS_WITH_AS(sim.remove(3), "particle = 3: is the last one and must stay", InvalidInput);
}

TEST_CASE("a particle breaks as before when others are removed and added while it is loaded") {
  // Before the square in the list lies another one, which goes away; operators, screening and
  // refused cuts are those of the index before.
  const auto run = [](const auto& with, bool changes) {
    Assembly assembly = square_between_platens(0.5);
    assembly.particles.insert(assembly.particles.begin(),
                              PlacedParticle{rectangle({0.2, 0}, 0.01, 0.02)});
    Simulation sim{with.criterion(MohrCoulomb{}), assembly, Rock{}};
    for (int n = 0; n < 400 && sim.breaks().empty(); ++n) {
      if (changes && n == 20) sim.remove(0);
      if (changes && n == 25) (void)sim.add(rectangle({0.2, 0}, 0.02, 0.02));
      sim.step();
    }
    REQUIRE(sim.breaks().size() == 1);
    CHECK(sim.breaks()[0].particle.id == 1);
    const BreakEvent& event = sim.breaks()[0];
    return std::vector<double>{static_cast<double>(event.step), event.line.point.x(),
                               event.line.point.y(), event.areas[0], event.areas[1]};
  };
  const auto expected = run(model(), false);
  CHECK(same_bytes(run(model(), true), expected));
  CHECK(same_bytes(run(model().without_acceleration(), true), expected));
}

TEST_CASE("a heap grows by dropping particles, and the ledger closes") {
  const double ground = -0.01;
  Simulation sim{model().criterion(NeverFails{}),
                 Assembly{.particles = {{rectangle({0, ground - 0.02}, 0.3, 0.04), Motion::wall},
                                        {rectangle({-0.06, 0.05}, 0.02, 0.3), Motion::wall},
                                        {rectangle({0.06, 0.05}, 0.02, 0.3), Motion::wall}}},
                 Rock{}};
  const double gravity = 100;
  sim.set_body_force({0, -gravity});
  EnergyLedger ledger;
  ledger.open(sim);
  Random random(3);
  std::vector<ParticleId> dropped;
  double kinetic = 0;
  double weight = 0;
  for (int n = 0; n < 40; ++n) {
    const ConvexPolygon polygon = random_polygon({}, 0.016, random);
    const Vec2 at{random.uniform(-0.035, 0.035), 0.15};
    dropped.push_back(sim.add(polygon.moved({}, at), Motion::free, {0, -2}));
    const Body& body = sim.particles().body(sim.index_of(dropped.back()));
    kinetic += body.kinetic_energy();
    weight += body.mass * gravity;
    const double until = sim.time() + 0.06;
    while (sim.time() < until) sim.step(ledger);
  }
  CHECK(sim.particles().size() == 43);
  CHECK(sim.work().added == near_relative(kinetic, 1e-12));
  const double rest = sim.time() + 0.2;
  while (sim.time() < rest) sim.step(ledger);
  // All lie between the walls, and ground and walls carry them.
  for (BodyIndex i = 3; i < 43; ++i) CHECK(sim.particles().body(i).position.y() > ground);
  const Vec2 carried = sim.force_on(0).force + sim.force_on(1).force + sim.force_on(2).force;
  CHECK(carried.y() == near_relative(-weight, 0.01));
  const EnergyTerms grown = ledger.terms(sim);
  CHECK(std::abs(grown.unclosed()) <= 0.01 * (grown.added + grown.body_force_work));

  // Every second one is taken away under the others, which fall.
  for (std::size_t k = 0; k < dropped.size(); k += 2) sim.remove(dropped[k]);
  CHECK(sim.particles().size() == 23);
  const double end = sim.time() + 0.2;
  while (sim.time() < end) sim.step(ledger);
  const EnergyTerms terms = ledger.terms(sim);
  CHECK(terms.added < grown.added);
  CHECK(std::abs(terms.unclosed()) <= 0.01 * (grown.added + terms.body_force_work));
  CHECK(std::abs(terms.law_residual) <= 0.01 * (grown.added + terms.body_force_work));
}
