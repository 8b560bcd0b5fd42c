// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/narrow_phase/overlap_chord.hpp>
#include <riprap/measurement/energy_ledger.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <riprap/dynamics/boundary/no_boundary.hpp>
#include <riprap/dynamics/damping/no_damping.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/fake_contacts.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

constexpr double thickness = 0.016;
constexpr double stiffness = 2e7;

// Masses are those of `area` times thickness times 2500.
double mass_of(double area) { return 2500 * thickness * area; }

// With forces of the stiffness times the depth.
auto elastic_model(double friction) {
  return Model{}
      .narrow_phase(OverlapChord{})
      .time_step(MassFloor{.fraction = 0.12})
      .criterion(NeverFails{})
      .damping(NoDamping{})
      .contact_law(LinearSpringCoulomb{
          .normal_stiffness = stiffness, .tangential_stiffness = stiffness, .friction = friction});
}

template <class Sim>
EnergyTerms run(Sim& sim, EnergyLedger& ledger, double until) {
  while (sim.time() < until) sim.step(ledger);
  return ledger.terms(sim);
}

// A spring and a dashpot that never pull together; k = 2e7 N/m.
struct SpringDashpot {
  struct History {};
  double damping = 0;  // [N s/m]

  ContactForce operator()(const ContactGeometry& geometry, const ContactMotion& motion,
                          History&) const {
    const double spring = stiffness * geometry.depth * geometry.depth_gradient;
    ContactForce force;
    force.normal = std::max(0.0, spring - damping * motion.normal_velocity);
    // What is not the spring's part of the force takes energy out.
    force.viscous_loss = (spring - force.normal) * motion.normal_velocity * motion.time_step;
    return force;
  }
  double stored_energy(const ContactGeometry& geometry, const History&) const {
    return 0.5 * stiffness * geometry.depth * geometry.depth;
  }
  double peak_stiffness() const { return stiffness; }
};

// What EnergyLedger reads from a simulation, to be set by hand.
struct FakeSimulation {
  Particles bodies{1, 1};
  FakeContacts list;
  BodyWork done;

  [[nodiscard]] const Particles& particles() const { return bodies; }
  [[nodiscard]] const FakeContacts& contacts() const { return list; }
  [[nodiscard]] const BodyWork& work() const { return done; }
  [[nodiscard]] double time_step() const { return 1e-3; }
};

}  // namespace

TEST_CASE("what the terms leave over is unclosed") {
  const EnergyTerms terms{.boundary_work = 1000,
                          .body_force_work = 200,
                          .kinetic = 1,
                          .stored = 2,
                          .slip = 4,
                          .dashpot = 8,
                          .damping = 16,
                          .breakage = 32,
                          .law_residual = 64};
  CHECK(terms.unclosed() == 1200 - 127);
}

TEST_CASE("in free fall the body force does m g h, all of it kinetic") {
  auto sim =
      Simulation{elastic_model(0), Assembly{thickness, {{rectangle({0, 0}, 0.01, 0.01)}}}, Rock{}};
  sim.set_body_force({0, -9.81});
  EnergyLedger ledger;
  ledger.open(sim);
  const EnergyTerms t = run(sim, ledger, 0.01);
  const double speed = 9.81 * sim.time();
  const double expected = 0.5 * mass_of(1e-4) * speed * speed;
  // Velocities of uniform acceleration are exact; round-off grows with some 6000 steps.
  CHECK(t.body_force_work == near_relative(expected, 1e-11));
  CHECK(t.kinetic == near_relative(expected, 1e-11));
  CHECK(t.unclosed() == near(0, 1e-14 * expected * 100));
}

TEST_CASE("local damping takes its share of the work of the body force") {
  const auto model = elastic_model(0).damping(LocalDamping{0.7});
  auto sim = Simulation{model, Assembly{thickness, {{rectangle({0, 0}, 0.01, 0.01)}}}, Rock{}};
  sim.set_body_force({6, -8});
  // From the start there is a velocity along the force, so that every step is damped.
  sim.set_velocity(0, {0.006, -0.008});
  EnergyLedger ledger;
  ledger.open(sim);
  const EnergyTerms t = run(sim, ledger, 0.01);
  const double speed = 0.01 + 0.3 * 10 * sim.time();
  const double gained = 0.5 * mass_of(1e-4) * (speed * speed - 1e-4);
  CHECK(t.kinetic == near_relative(gained, 1e-10));
  CHECK(t.body_force_work == near_relative(gained / 0.3, 1e-10));
  CHECK(t.damping == near_relative(gained * 0.7 / 0.3, 1e-10));
  CHECK(t.unclosed() == near(0, 1e-12 * gained));
}

TEST_CASE("two elastic blocks turn kinetic into stored energy and back") {
  for (const double angle : {0.0, 0.7}) {
    CAPTURE(angle);
    // A 10 mm square and a lower block, 1 micron apart, that meet at 3 m/s.
    const Rotation turn = Rotation::from_angle(angle);
    const Vec2 shift{0.3, -0.1};
    Assembly assembly{thickness,
                      {{rectangle({0, 0}, 0.01, 0.01).moved(turn, shift)},
                       {rectangle({0.010001, 0}, 0.01, 0.006).moved(turn, shift)}}};
    assembly.particles[0].velocity = turn * Vec2{2, 0};
    assembly.particles[1].velocity = turn * Vec2{-1, 0};
    auto sim = Simulation{elastic_model(0.5), assembly, Rock{}};
    sim.set_time_step(1e-8);
    const double m_a = mass_of(1e-4);
    const double m_b = mass_of(0.6e-4);
    const double m = m_a * m_b / (m_a + m_b);
    const double relative_energy = 0.5 * m * 9;
    const double omega = std::sqrt(stiffness / m);
    const double step = omega * sim.time_step();  // a small number, 1e-3

    EnergyLedger ledger;
    ledger.open(sim);
    const double meet = 1e-6 / 3;
    const EnergyTerms deepest = run(sim, ledger, meet + 0.5 * std::numbers::pi / omega);
    // Velocities lie half a step from positions: the instant is off by at most a step or so, and
    // energies are stationary there (second order); the power at hand times half a step is
    // unclosed.
    CHECK(deepest.stored == near_relative(relative_energy, 2 * step));
    CHECK(deepest.kinetic == near_relative(-relative_energy, 2 * step));
    CHECK(deepest.unclosed() == near(0, step * relative_energy));

    const EnergyTerms after = run(sim, ledger, meet + 1.1 * std::numbers::pi / omega);
    REQUIRE(after.stored == 0);
    // Linear springs and straight motion: the trapezoid is exact but for the two steps in which
    // contact begins and ends, each off by less than k (v dt)^2 / 2.
    CHECK(after.law_residual == near(0, 2 * step * step * relative_energy));
    CHECK(after.kinetic == near(0, 2 * step * step * relative_energy));
    CHECK(after.slip == near(0, 1e-9 * relative_energy));
    CHECK(after.unclosed() == near(0, 1e-10 * relative_energy));
    // Each bounces with the velocity of an elastic collision.
    const double v_a = 2 - 2 * m_b / (m_a + m_b) * 3;
    CHECK((sim.particles().body(0).velocity - turn * Vec2{v_a, 0}).norm() == near(0, 1e-5));
  }
}

TEST_CASE("an oblique collision with friction and spin closes to round-off") {
  // All terms are at work: springs, slip, spin, and a contact law that is not conservative.
  Assembly assembly{thickness,
                    {{rectangle({0, 0}, 0.01, 0.01)},
                     {ConvexPolygon{{0.006, 0.000}, {0.014, -0.002}, {0.012, 0.007}}}}};
  assembly.particles[0].velocity = {2, 1};
  assembly.particles[0].angular_velocity = 150;
  assembly.particles[1].velocity = {-1, -0.5};
  auto sim = Simulation{elastic_model(0.3), assembly, Rock{}};
  EnergyLedger ledger;
  ledger.open(sim);
  double most_stored = 0;
  while (sim.time() < 2e-3) {
    sim.step(ledger);
    most_stored = std::max(most_stored, stored_energy(sim.contacts()));
  }
  const EnergyTerms t = ledger.terms(sim);
  REQUIRE(most_stored > 1e-3);
  REQUIRE(t.stored == 0);
  REQUIRE(t.slip > 0.01 * most_stored);
  CHECK(t.kinetic < 0);
  // Before and after there is no force, so the sums over steps of the ledger and of the bodies are
  // the same sums in another order, whatever the time step.
  CHECK(t.unclosed() == near(0, 1e-12 * most_stored));
  CHECK(std::abs(t.law_residual) < 0.1 * most_stored);
}

TEST_CASE("half the work of a conveyor belt that takes up a block is lost in slip") {
  // Two belts hold a block between them, both move along axis 1; friction takes the block along.
  constexpr double grip = 1e-5;  // overlap [m]: 200 N on each side
  constexpr double speed = 1;
  constexpr double friction = 0.5;
  Assembly assembly{thickness, {{rectangle({0, 0}, 0.01, 0.006)}}};
  for (const double sign : {1.0, -1.0})
    assembly.particles.push_back({.polygon = rectangle({0, sign * (0.013 - grip)}, 0.1, 0.02),
                                  .motion = Motion::prescribed,
                                  .velocity = {speed, 0}});
  auto sim = Simulation{elastic_model(friction), assembly, Rock{}};
  sim.set_time_step(2e-8);
  EnergyLedger ledger;
  ledger.open(sim);
  REQUIRE(stored_energy(sim.contacts()) == near_relative(stiffness * grip * grip, 1e-9));
  while (sim.particles().body(0).velocity.x() < speed) sim.step(ledger);
  const EnergyTerms t = ledger.terms(sim);

  const double m = mass_of(0.6e-4);
  const double limit = friction * stiffness * grip;  // on each side
  const double held = limit * limit / stiffness;     // in both tangential springs
  // The block arrives at the speed of the belts within a step, dt * 2 limit / m of it, and the
  // power at hand times half a step is unclosed.
  const double tolerance = 2 * limit * speed * sim.time_step();
  CHECK(t.boundary_work == near(m * speed * speed, tolerance));
  CHECK(t.kinetic == near(0.5 * m * speed * speed, tolerance));
  CHECK(t.stored == near(held, 1e-4 * held));
  CHECK(t.slip == near(0.5 * m * speed * speed - held, tolerance));
  CHECK(t.damping == 0);
  CHECK(t.dashpot == 0);
  CHECK(t.breakage == 0);
  CHECK(t.law_residual == near(0, tolerance));
  CHECK(t.unclosed() == near(0, tolerance));
  REQUIRE(tolerance < 0.01 * m * speed * speed);
}

TEST_CASE("pushed against friction a block turns the work of the push into slip") {
  // A block between two fixed floors, moving at the speed of the body that pushes it from the left
  // with just the force that sliding needs. The springs of friction have to be drawn first, so that
  // it swings a little about that speed and never comes to rest.
  constexpr double grip = 1e-5;  // overlap [m]: 200 N on each side
  constexpr double speed = 2;
  constexpr double friction = 0.5;
  constexpr double push = 2 * friction * stiffness * grip;
  Assembly assembly{thickness, {{rectangle({0, 0}, 0.01, 0.006)}}};
  assembly.particles[0].velocity = {speed, 0};
  for (const double sign : {1.0, -1.0})
    assembly.particles.push_back({.polygon = rectangle({0, sign * (0.013 - grip)}, 0.1, 0.02),
                                  .motion = Motion::prescribed});
  assembly.particles.push_back({.polygon = rectangle({-0.01 + push / stiffness, 0}, 0.01, 0.003),
                                .motion = Motion::prescribed,
                                .velocity = {speed, 0}});
  auto sim = Simulation{elastic_model(friction), assembly, Rock{}};
  EnergyLedger ledger;
  while (sim.time() < 1e-4) sim.step();  // friction is at its limit by now
  ledger.open(sim);
  const auto squeeze = [&] {
    return sim.particles().body(3).position.x() - sim.particles().body(0).position.x() + 0.01;
  };
  const double start_squeeze = squeeze();
  const Body start = sim.particles().body(0);
  const double opened = sim.time();
  const EnergyTerms t = run(sim, ledger, 4e-3);
  const double end_squeeze = squeeze();
  const Body end = sim.particles().body(0);

  // What the push has done follows from the momentum, what was lost in slip from the way.
  const double m = mass_of(0.6e-4);
  const double duration = sim.time() - opened;
  const double momentum = m * (end.velocity.x() - start.velocity.x());
  const double work = speed * (momentum + push * duration);
  const double slip = push * (end.position.x() - start.position.x());
  REQUIRE(work > 0.5);
  // Round-off of some 3000 steps, in positions of 5 cm against overlaps of 0.01 mm.
  CHECK(t.boundary_work == near_relative(work, 1e-9));
  CHECK(t.slip == near_relative(slip, 1e-9));
  CHECK(t.kinetic ==
        near(0.5 * m *
                 (end.velocity.x() * end.velocity.x() - start.velocity.x() * start.velocity.x()),
             1e-9 * work));
  CHECK(t.stored ==
        near(0.5 * stiffness * (end_squeeze * end_squeeze - start_squeeze * start_squeeze),
             1e-9 * work));
  CHECK(t.damping == 0);
  CHECK(t.dashpot == 0);
  CHECK(t.law_residual == near(0, 1e-9 * work));
  // The power of push and friction at hand, from the start and from the end, times half a step.
  const double tolerance = 2 * push * speed * sim.time_step();
  REQUIRE(tolerance < 1e-3 * work);
  CHECK(t.unclosed() == near(0, tolerance));
}

TEST_CASE("a dashpot takes the energy that a bounce does not give back") {
  // Of two blocks that meet head on, damping ratio 0.2. The restitution of a spring and dashpot
  // without tension (Schwager and Poeschel 2007) is 0.571740.
  constexpr double restitution = 0.571740;
  const double mass = mass_of(1e-4);
  const double effective = 0.5 * mass;
  Assembly assembly{thickness,
                    {{rectangle({0, 0}, 0.01, 0.01)}, {rectangle({0.010001, 0}, 0.01, 0.01)}}};
  assembly.particles[0].velocity = {1, 0};
  assembly.particles[1].velocity = {-1, 0};
  auto sim = Simulation{
      elastic_model(0).contact_law(SpringDashpot{2 * 0.2 * std::sqrt(stiffness * effective)}),
      assembly, Rock{}};
  sim.set_time_step(5e-9);
  EnergyLedger ledger;
  ledger.open(sim);
  const EnergyTerms t = run(sim, ledger, 1e-4);
  REQUIRE(t.stored == 0);
  const double before = 0.5 * effective * 4;
  const double lost = (1 - restitution * restitution) * before;
  // First order in omega dt = 5e-4, for the dashpot uses velocities half a step old.
  CHECK(t.kinetic == near_relative(-lost, 2e-3));
  CHECK(t.dashpot == near_relative(lost, 2e-3));
  CHECK(t.law_residual == near(0, 2e-3 * lost));
  CHECK(t.unclosed() == near(0, 1e-10 * lost));
}

TEST_CASE("the ledger closes through a break under a platen that also shears") {
  // A pentagon crushed on a fixed floor by a platen that comes down and moves sideways.
  Assembly assembly{
      thickness,
      {{ConvexPolygon{
          {-0.006, 0.0005}, {0.005, 0}, {0.009, 0.007}, {0.001, 0.014}, {-0.008, 0.008}}}}};
  assembly.particles.push_back(
      {.polygon = rectangle({0, -0.005}, 0.06, 0.01), .motion = Motion::prescribed});
  assembly.particles.push_back({.polygon = rectangle({0, 0.019}, 0.06, 0.01),
                                .motion = Motion::prescribed,
                                .velocity = {0.3, -0.5}});
  const auto model = Model{}
                         .boundary(NoBoundary{})
                         .criterion(HoekBrown{.compressive_strength = 20e6})
                         .trigger(FailedElementRatio{.critical = 0.2});
  Simulation sim{model, assembly, Rock{}};
  EnergyLedger ledger;
  ledger.open(sim);
  while (sim.breaks().empty() && sim.steps() < 20000) sim.step(ledger);
  REQUIRE(sim.breaks().size() == 1);
  for (int i = 0; i < 500; ++i) sim.step(ledger);
  const EnergyTerms t = ledger.terms(sim);
  CHECK(t.breakage != 0);
  CHECK(t.slip > 0);
  CHECK(t.damping > 0);
  // The pieces have flown off: without a force at either end of the run the sums over steps of the
  // ledger and of the bodies are the same sums in another order.
  REQUIRE(t.stored == 0);
  CHECK(t.unclosed() == near(0, 1e-12 * t.boundary_work));
}

TEST_CASE("energy that vanishes when particles split is breakage, nothing is counted twice") {
  FakeSimulation sim;
  const BodyIndex i = sim.bodies.add(rectangle({0, 0}, 1, 1), Motion::free);
  sim.bodies.body(i).velocity = {4, 0};  // 8 J
  sim.list.contact_law = {.normal_stiffness = 2, .tangential_stiffness = 2, .friction = 0.5};
  FakeContact contact = fake_contact(0, 1, {0, 0}, {1, 0}, {1, 0}, 0, 0);
  contact.geometry.depth = 3;            // 9 J
  contact.history.tangential_force = 2;  // 1 J
  sim.list.list = {contact};

  EnergyLedger ledger;
  ledger.open(sim);
  ledger.before_splits(sim);
  // The pieces meet their neighbour less deeply, 4 + 1/4 J, and are slower, 2 J. The smaller normal
  // force no longer holds the tangential one: 1/2 J went into slip.
  sim.list.list[0].geometry.depth = 2;
  sim.list.list[0].history.tangential_force = 1;
  sim.list.lost_in_slip = 0.5;
  sim.bodies.body(i).velocity = {2, 0};
  ledger.after_splits(sim);

  const EnergyTerms t = ledger.terms(sim);
  CHECK(t.stored == near(4.25 - 10, 1e-14));
  CHECK(t.kinetic == near(-6, 1e-14));
  CHECK(t.slip == 0.5);
  CHECK(t.breakage == near(5.75 + 6 - 0.5, 1e-14));
  CHECK(t.law_residual == 0);
  CHECK(t.unclosed() == near(0, 1e-14));
}

TEST_CASE("a ledger counts from when it was opened") {
  FakeSimulation sim;
  sim.done = {.boundary = 7, .body_force = 3, .damping = 2};
  sim.list.lost_in_slip = 5;
  sim.list.lost_in_dashpots = 4;
  EnergyLedger ledger;
  // Until then its hooks do nothing.
  ledger.before_forces(sim);
  ledger.after_forces(sim);
  ledger.before_splits(sim);
  ledger.after_splits(sim);
  ledger.open(sim);
  CHECK(ledger.terms(sim).boundary_work == 0);
  CHECK(ledger.terms(sim).law_residual == 0);
  sim.done = {.boundary = 17, .body_force = 23, .damping = 32};
  sim.list.lost_in_slip = 45;
  sim.list.lost_in_dashpots = 54;
  const EnergyTerms t = ledger.terms(sim);
  CHECK(t.boundary_work == 10);
  CHECK(t.body_force_work == 20);
  CHECK(t.damping == 30);
  CHECK(t.slip == 40);
  CHECK(t.dashpot == 50);
  ledger.open(sim);
  CHECK(ledger.terms(sim).slip == 0);
}
