// SPDX-License-Identifier: BSL-1.0
// A simulation in a periodic cell: the border of the cell is nowhere.

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <riprap/contact/contact_law/overlap_area_spring.hpp>
#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/dynamics/damping/no_damping.hpp>
#include <riprap/measurement/average_stress.hpp>
#include <riprap/measurement/energy_ledger.hpp>
#include <riprap/particle/random_box_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

// Undamped, so that it makes no difference whether all bodies move at a common velocity.
auto undamped() {
  return Model{}.criterion(NeverFails{}).damping(NoDamping{}).boundary(PeriodicCell{});
}

template <class Sim>
Stress2 stress(const Sim& sim) {
  return average_stress(sim.contacts(), sim.boundary().region(sim.particles()).area(),
                        sim.particles().thickness());
}

// Small, and carries the pressure [Pa]; its bodies move with the cell.
template <class ModelType>
auto compressed_sample(ModelType model, double pressure) {
  constexpr double rate = 20;  // [1/s]
  Assembly loose = random_periodic_assembly({.count = 60, .seed = 4, .solid_fraction = 0.5});
  for (PlacedParticle& p : loose.particles)
    p.velocity = -rate * area_properties(p.polygon.ring()).centroid;
  Simulation sim{model, loose, Rock{}};
  sim.boundary().set_rate(rate, rate);
  while (stress(sim).mean() < pressure) sim.step();
  return sim;
}

// The present state as an assembly; contacts begin anew.
template <class Sim>
Assembly state_of(const Sim& sim) {
  Assembly now{.thickness = sim.particles().thickness(),
               .particles = {},
               .period = sim.boundary().domain().period};
  for (BodyIndex i = 0; i < sim.particles().size(); ++i) {
    const Ring ring = sim.particles().ring(i);
    const Body& body = sim.particles().body(i);
    now.particles.push_back({ConvexPolygon(std::vector<Vec2>(ring.begin(), ring.end())),
                             Motion::free, body.velocity, body.angular_velocity});
  }
  return now;
}

void check_same(const Stress2& p, const Stress2& q, double relative) {
  const double tolerance = relative * std::abs(q.mean());
  CHECK(p.s11 == near(q.s11, tolerance));
  CHECK(p.s22 == near(q.s22, tolerance));
  CHECK(p.s12 == near(q.s12, tolerance));
}

}  // namespace

TEST_CASE("two squares press on each other across the border of the cell") {
  const ConvexPolygon square{{0, 0}, {0.01, 0}, {0.01, 0.01}, {0, 0.01}};
  const ConvexPolygon low{{0, 0}, {0.01, 0}, {0.01, 0.006}, {0, 0.006}};
  // The right one meets the image of the left one with a depth of 1e-5: force 2 k d w^4 / (w^2 +
  // d^2)^2 over a width w of 6e-3.
  const Assembly pair{
      .particles = {{low.moved({}, {-0.02, 0.002})}, {square.moved({}, {0.01001, 0})}},
      .period = {0.04, 0.1}};
  const Simulation sim{undamped(), pair, Rock{}};
  const double force = 2 * 2e7 * 1e-5 / std::pow(1 + std::pow(1e-5 / 6e-3, 2), 2);
  int count = 0;
  sim.contacts().for_each_touching([&](const auto& c) {
    ++count;
    CHECK((c.force_on_b() - Vec2{-force, 0}).norm() == near(0, 1e-6));
    // From the left one to the image of the right one.
    CHECK((c.branch() - Vec2{-0.00999, 0}).norm() == near(0, 1e-15));
    // The point is the middle of the overlap.
    CHECK((c.arm_b - Vec2{0.005 - 5e-6, 0}).norm() == near(0, 1e-15));
  });
  CHECK(count == 1);
  CHECK((sim.particles().body(0).contact.force - Vec2{force, 0}).norm() == near(0, 1e-6));
  CHECK((sim.particles().body(1).contact.force - Vec2{-force, 0}).norm() == near(0, 1e-6));
}

TEST_CASE("results do not depend on where the border of the cell is") {
  const Assembly sample = state_of(compressed_sample(undamped(), 3e5));
  // Everything is shifted by a part of the cell, and every third body by whole periods on top.
  Assembly shifted = sample;
  for (std::size_t i = 0; i < shifted.particles.size(); ++i) {
    const double periods = i % 3 == 0 ? 2 : 0;
    const Vec2 shift = sample.period.cwiseProduct(Vec2{0.31 + periods, -0.17 - periods});
    shifted.particles[i].polygon = shifted.particles[i].polygon.moved({}, shift);
  }
  Simulation here{undamped(), sample, Rock{}};
  Simulation there{undamped(), shifted, Rock{}};
  for (int n = 0; n < 50; ++n) {
    here.step();
    there.step();
  }
  CHECK(here.contacts().friction_loss() > 0);
  // Coordinates of 0.3 m have a round-off of 5e-17 m, depths are 1e-5 m: 1e-11 at the start, which
  // grows tenfold in fifty steps of collisions.
  check_same(stress(there), stress(here), 1e-9);
}

TEST_CASE("damping does not depend on which copy of a body is stored") {
  // As above, with the default damping and a field: an image is faster by the field's velocity.
  const auto model = Model{}.criterion(NeverFails{}).boundary(PeriodicCell{});
  const Vec2 rate{0.03, -0.01};
  const Assembly sample = state_of(compressed_sample(model, 3e5));
  Assembly shifted = sample;
  for (std::size_t i = 0; i < shifted.particles.size(); i += 3) {
    const Vec2 shift = sample.period.cwiseProduct(Vec2{2, -3});
    shifted.particles[i].polygon = shifted.particles[i].polygon.moved({}, shift);
    shifted.particles[i].velocity -= rate.cwiseProduct(shift);
  }
  Simulation here{model, sample, Rock{}};
  Simulation there{model, shifted, Rock{}};
  for (auto* sim : {&here, &there}) {
    sim->boundary().set_rate(rate.x(), rate.y());
    for (int n = 0; n < 50; ++n) sim->step();
  }
  // The field shrinks as it moves, which is an acceleration of rate^2 times the shift, 3e-4 m/s^2
  // against some 1e4 in the contacts: 1e-7 is left of it after fifty steps.
  check_same(stress(there), stress(here), 1e-7);
}

TEST_CASE("contact forces of a periodic sample add up to nothing") {
  const auto sim = compressed_sample(undamped(), 3e5);
  Vec2 sum{0, 0};
  double largest = 0;
  for (const Body& body : sim.particles().bodies()) {
    sum += body.contact.force;
    largest = std::max(largest, body.contact.force.norm());
  }
  CHECK(sum.norm() <= 1e-13 * 60 * largest);
  CHECK(largest > 1);
}

TEST_CASE("the work of the cell is stress times strain, and the ledger closes") {
  // At rest first: in motion the momentum that bodies carry adds to the stress.
  auto sim = compressed_sample(Model{}.criterion(NeverFails{}).boundary(PeriodicCell{}), 5e6);
  const auto run = [&sim](double rate, int steps) {
    sim.boundary().set_rate(rate, rate);
    for (int n = 0; n < steps; ++n) sim.step();
  };
  run(0, 3700);
  // The pressure may have been that of an impact.
  for (int k = 0; k < 40 && stress(sim).mean() < 1e6; ++k) {
    run(2, 500);
    run(0, 3700);
  }
  REQUIRE(stress(sim).mean() > 1e6);
  EnergyLedger ledger;
  ledger.open(sim);
  sim.boundary().set_rate(0.3, 0.5);
  double work = 0;
  const double thickness = sim.particles().thickness();
  constexpr int steps = 2450;
  for (int n = 0; n < steps; ++n) {
    const Stress2 s = stress(sim);
    const double volume = sim.boundary().region(sim.particles()).area() * thickness;
    work += sim.time_step() * volume * (0.3 * s.s11 + 0.5 * s.s22);
    sim.step(ledger);
  }
  const EnergyTerms terms = ledger.terms(sim);
  REQUIRE(work > 0);
  // The sample follows its cell with a lag, in which waves carry a little of the work.
  CHECK(terms.boundary_work == near_relative(work, 0.02));
  // Of first order in the step: a force that grows evenly from nothing, summed with a lag of a
  // step, is off by 2 / n of its work. An image that moved without its velocity being booked would
  // leave all of the work.
  CHECK(std::abs(terms.unclosed()) <= 2.0 / steps * terms.boundary_work);
  CHECK(std::abs(terms.law_residual) <= 1e-3 * terms.boundary_work);
}

TEST_CASE("a periodic assembly needs a periodic cell, and vice versa") {
  const Assembly sample = random_periodic_assembly({.count = 60, .seed = 4});
  CHECK_THROWS_WITH_AS((Simulation{Model{}, sample, Rock{}}),
                       "Assembly.period is set: give the model a PeriodicCell as its boundary",
                       InvalidInput);
  Assembly open = sample;
  open.period = {0, 0};
  CHECK_THROWS_AS((Simulation{Model{}.boundary(PeriodicCell{}), open, Rock{}}), InvalidInput);
}
