// SPDX-License-Identifier: BSL-1.0
// A periodic cell in simple shear (Lees and Edwards 1972).

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include <riprap/contact/broad_phase/all_pairs.hpp>
#include <riprap/dynamics/boundary/periodic_cell.hpp>
#include <riprap/dynamics/damping/no_damping.hpp>
#include <riprap/measurement/average_stress.hpp>
#include <riprap/measurement/energy_ledger.hpp>
#include <riprap/particle/random_box_assembly.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>
#include <support/same_run.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

constexpr double rate = 20;  // of shear [1/s]

auto damped() { return Model{}.criterion(NeverFails{}).boundary(PeriodicCell{}); }
auto undamped() { return damped().damping(NoDamping{}); }

template <class Sim>
Stress2 stress(const Sim& sim) {
  return average_stress(sim.contacts(), sim.boundary().region(sim.particles()).area(),
                        sim.particles().thickness());
}

// Whose bodies move with a cell that is sheared at `rate`.
Assembly loose_sample() {
  Assembly loose = random_periodic_assembly({.count = 60, .seed = 4, .solid_fraction = 0.5});
  for (PlacedParticle& p : loose.particles)
    p.velocity = Vec2{rate * area_properties(p.polygon.ring()).centroid.y(), 0};
  return loose;
}

// Sheared and shortened until it carries a pressure [Pa] and its offset exceeds half a period.
template <class ModelType>
auto sheared_sample(const ModelType& model) {
  Simulation sim{model, loose_sample(), Rock{}};
  sim.boundary().set_shear_rate(rate);
  sim.boundary().set_rate(8, 8);
  const auto& domain = sim.boundary().domain();
  while (stress(sim).mean() < 3e5 || domain.shear_offset < 0.55 * domain.period.x()) {
    if (stress(sim).mean() > 3e5) sim.boundary().set_rate(0, 0);
    sim.step();
  }
  return sim;
}

// The present state as an assembly; contacts begin anew.
template <class Sim>
Assembly state_of(const Sim& sim) {
  const PeriodicDomain& domain = sim.boundary().domain();
  Assembly now{.thickness = sim.particles().thickness(),
               .particles = {},
               .period = domain.period,
               .shear_offset = domain.shear_offset};
  for (BodyIndex i = 0; i < sim.particles().size(); ++i) {
    const Ring ring = sim.particles().ring(i);
    const Body& body = sim.particles().body(i);
    now.particles.push_back({ConvexPolygon(std::vector<Vec2>(ring.begin(), ring.end())),
                             Motion::free, body.velocity, body.angular_velocity});
  }
  return now;
}

template <class Sim>
std::vector<double> numbers_of(const Sim& sim) {
  std::vector<double> numbers{sim.work().boundary, sim.contacts().friction_loss()};
  for (const Body& b : sim.particles().bodies())
    for (const double x : {b.position.x(), b.position.y(), b.velocity.x(), b.angular_velocity,
                           b.contact.force.x(), b.contact.force.y(), b.contact.moment})
      numbers.push_back(x);
  return numbers;
}

void check_same(const Stress2& p, const Stress2& q, double relative) {
  const double tolerance = relative * std::abs(q.mean());
  CHECK(p.s11 == near(q.s11, tolerance));
  CHECK(p.s22 == near(q.s22, tolerance));
  CHECK(p.s12 == near(q.s12, tolerance));
}

}  // namespace

TEST_CASE("two rectangles press on and rub each other across the sheared border of the cell") {
  // The image of the small one lies on the large one with a depth of 1e-5: force 2 k d w^4 / (w^2 +
  // d^2)^2 over its width w of 0.01. The same with rows that are a whole period further on.
  const double depth = 1e-5;
  const Assembly pair{.particles = {{rectangle({0, 0.01}, 0.02, 0.02), Motion::prescribed},
                                    {rectangle({-0.012, -0.015 - depth}, 0.01, 0.01)}},
                      .period = {0.1, 0.04},
                      .shear_offset = 0.013};
  const double force = 2 * 2e7 * depth / std::pow(1 + std::pow(depth / 0.01, 2), 2);
  for (const int periods : {0, -1, 1, 7}) {
    CAPTURE(periods);
    Assembly shifted = pair;
    shifted.shear_offset += periods * pair.period.x();
    Simulation sim{undamped(), shifted, Rock{}};
    const double strain_rate = 0.1;
    sim.boundary().set_shear_rate(strain_rate);
    int count = 0;
    sim.contacts().for_each_touching([&](const auto& c) {
      ++count;
      CHECK(c.image == PeriodicDomain::Image{-periods, 1});
      CHECK((c.force_on_b() - Vec2{0, force}).norm() == near(0, 1e-6));
      CHECK((c.branch() - Vec2{0.001, 0.015 - depth}).norm() == near(0, 1e-14));
    });
    REQUIRE(count == 1);
    sim.step();
    // The image slides on the large one at the speed of its row, against which the spring pulls.
    // The power of the cell is that pull times that speed.
    const double speed = strain_rate * 0.04;
    const double pull = 2e7 * speed * sim.time_step();
    sim.contacts().for_each_touching([&](const auto& c) {
      CHECK(sim.contacts().relative_velocity(c, sim.particles()).x() == near_relative(speed, 1e-9));
      CHECK(c.force_on_b().x() == near_relative(-pull, 1e-6));  // turns by 1e-9 rad meanwhile
    });
    CHECK(sim.contacts().image_power() == near_relative(pull * speed, 1e-6));
  }
}

TEST_CASE("neighbours found with a Verlet list are those of a search at every step, to the byte") {
  const auto numbers = [](const auto& model) {
    Simulation sim{model, loose_sample(), Rock{}};
    sim.boundary().set_shear_rate(rate);
    sim.boundary().set_rate(8, 8);
    std::vector<double> all;
    const PeriodicDomain& domain = sim.boundary().domain();
    while (domain.shear_offset < 0.55 * domain.period.x()) {
      if (stress(sim).mean() > 3e5) sim.boundary().set_rate(0, 0);
      sim.step();
      if (sim.steps() % 16 == 0)
        for (const double x : numbers_of(sim)) all.push_back(x);
    }
    CHECK(sim.contacts().friction_loss() > 0);
    return all;
  };
  const auto expected =
      numbers(damped().neighbour_list(RebuildEveryStep{}).broad_phase(AllPairs{}));
  CHECK(same_bytes(numbers(damped()), expected));
}

TEST_CASE("results depend neither on whole periods of the offset nor on which copy is stored") {
  const Assembly sample = state_of(sheared_sample(damped()));
  REQUIRE(sample.shear_offset > 0.5 * sample.period.x());
  const Vec2 shortening{0.03, -0.01};
  const auto run = [&](const Assembly& assembly) {
    Simulation sim{damped(), assembly, Rock{}};
    sim.boundary().set_shear_rate(rate);
    sim.boundary().set_rate(shortening.x(), shortening.y());
    for (int n = 0; n < 50; ++n) sim.step();
    CHECK(sim.contacts().friction_loss() > 0);
    return stress(sim);
  };
  const Stress2 expected = run(sample);
  Assembly reduced = sample;
  reduced.shear_offset -= sample.period.x();
  // An offset of one period more grows by the shortening of that period.
  check_same(run(reduced), expected, 1e-9);

  Assembly copies = sample;
  for (std::size_t i = 0; i < copies.particles.size(); i += 3) {
    const Vec2 shift{2 * sample.period.x() - 3 * sample.shear_offset, -3 * sample.period.y()};
    copies.particles[i].polygon = copies.particles[i].polygon.moved({}, shift);
    copies.particles[i].velocity += Vec2{rate * shift.y(), 0} - shortening.cwiseProduct(shift);
  }
  // The field accelerates as the cell deforms, by rate times velocity: against the accelerations
  // in the contacts some 1e-5 is left after fifty steps.
  check_same(run(copies), expected, 1e-4);
}

TEST_CASE("results do not depend on the velocity of the sample as a whole") {
  const Assembly sample = state_of(sheared_sample(undamped()));
  Assembly carried = sample;
  for (PlacedParticle& p : carried.particles) p.velocity += Vec2{0.7, -0.4};
  const auto run = [&](const Assembly& assembly) {
    Simulation sim{undamped(), assembly, Rock{}};
    sim.boundary().set_shear_rate(rate);
    for (int n = 0; n < 50; ++n) sim.step();
    return stress(sim);
  };
  check_same(run(carried), run(sample), 1e-9);
}

TEST_CASE("the power of the cell is that of the contact forces in its velocity field") {
  // Virtual work: forces f on b over branches l and resultants F at x, sum -f G l + F G x. Exact in
  // any state.
  auto sim = sheared_sample(damped());
  sim.boundary().set_rate(3, -2);
  sim.step();
  const PeriodicDomain& domain = sim.boundary().domain();
  double power = 0;
  double size = 0;
  sim.contacts().for_each_touching([&](const auto& c) {
    power -= c.force_on_b().dot(domain.field(c.branch()));
    size += std::abs(c.force_on_b().dot(domain.field(c.branch())));
  });
  for (const Body& body : sim.particles().bodies())
    power += body.contact.force.dot(domain.field(body.position));
  REQUIRE(size > 0);
  CHECK(sim.contacts().image_power() == near(power, 1e-12 * size));
}

TEST_CASE("the work of shear is shear stress times strain, and the ledger closes") {
  auto sim = sheared_sample(damped());
  const auto run = [&sim](double shortening, int steps) {
    sim.boundary().set_rate(shortening, shortening);
    for (int n = 0; n < steps; ++n) sim.step();
  };
  sim.boundary().set_shear_rate(0);
  for (int k = 0; k < 60 && stress(sim).mean() < 1e6; ++k) {
    run(2, 500);
    run(0, 3700);
  }
  REQUIRE(stress(sim).mean() > 1e6);
  EnergyLedger ledger;
  ledger.open(sim);
  sim.boundary().set_rate(0, 0.1);
  sim.boundary().set_shear_rate(0.5);
  double work = 0;
  constexpr int steps = 5000;
  for (int n = 0; n < steps; ++n) {
    const Stress2 s = stress(sim);
    const double volume =
        sim.boundary().region(sim.particles()).area() * sim.particles().thickness();
    work += sim.time_step() * volume * (0.1 * s.s22 - 0.5 * s.s12);
    sim.step(ledger);
  }
  CHECK(stress(sim).s12 < 0);
  const EnergyTerms terms = ledger.terms(sim);
  REQUIRE(work > 0);
  // The sample follows its cell with a lag, in which waves carry a little of the work.
  CHECK(terms.boundary_work == near_relative(work, 0.02));
  CHECK(std::abs(terms.unclosed()) <= 4.0 / steps * terms.boundary_work);
  CHECK(std::abs(terms.law_residual) <= 1e-3 * terms.boundary_work);
}
