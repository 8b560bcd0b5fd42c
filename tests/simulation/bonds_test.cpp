// SPDX-License-Identifier: BSL-1.0
#include <riprap/simulation/bond_stage.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/bond/bond_law/softening_bond.hpp>
#include <riprap/dynamics/damping/no_damping.hpp>
#include <riprap/dynamics/integrator/velocity_verlet.hpp>
#include <riprap/dynamics/time_step/fixed_time_step.hpp>
#include <riprap/measurement/energy_ledger.hpp>
#include <riprap/particle/bond_common_edges.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>
#include <support/unbreakable.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

constexpr double side = 0.1;
constexpr double density = 2500;
constexpr double k_n = 2e11;
constexpr double k_s = 0.7e11;
constexpr double area = side * 1;  // of a common edge; the thickness is 1 m
constexpr double mass = density * side * side;

constexpr BrittleBond strong{.normal_stiffness = k_n,
                             .tangential_stiffness = k_s,
                             .tensile_strength = 1e30,
                             .cohesion = 1e30,
                             .friction = 0};

/// Squares in a row, bonded; the first one is held.
Assembly row(std::size_t cells, Motion first = Motion::prescribed) {
  Assembly assembly = of({});
  for (std::size_t i = 0; i < cells; ++i)
    assembly.particles.push_back(
        {rectangle({side * static_cast<double>(i), 0}, side, side), i == 0 ? first : Motion::free});
  bond_common_edges(assembly);
  return assembly;
}

template <BondLaw Law>
auto still(const Law& law) {
  return damped(springs(1e7, 0.5)).bond_law(law);
}
template <BondLaw Law>
auto moving(const Law& law) {
  return undamped(springs(1e7, 0.5)).bond_law(law).integrator(VelocityVerlet{});
}

struct Watch {
  std::vector<BondBreak> seen;
  void on_bond_break(const auto& sim, const BondBreak& event) {
    seen.push_back(event);
    CHECK(sim.bonds().size() == 3);
  }
};

std::vector<double> state_of(const Particles& particles) {
  std::vector<double> numbers;
  for (const Body& b : particles.bodies())
    for (const double x :
         {b.position.x(), b.position.y(), b.rotation.sine, b.velocity.x(), b.velocity.y(),
          b.angular_velocity, b.contact.force.x(), b.contact.force.y(), b.contact.moment})
      numbers.push_back(x);
  return numbers;
}

}  // namespace

TEST_CASE("a bar in tension: its bonds are springs in series") {
  Simulation sim{still(strong), row(6), rock_of(density)};
  CHECK(sim.bonds().size() == 5);
  const double force = 1e5;
  sim.set_load(5, {force, 0});
  for (int n = 0; n < 6000; ++n) sim.step();
  const double extension = sim.particles().body(5).position.x() - 5 * side;
  // Positions have an error of 1e-16 of 0.5 m, 1e-11 of the extension.
  CHECK(extension == near_relative(5 * force / (k_n * area), 1e-9));
  // The support carries it.
  CHECK(sim.bond_force_on(0).force.x() == near_relative(force, 1e-9));
  CHECK(sim.bond_force_on(0).moment == near(0, 1e-9 * force * side));
}

TEST_CASE("a bar that is free at one end swings at the frequency of a chain of masses") {
  // Mode of a chain of N masses and N springs, held at one end: sin(q i) with q = pi / (2 N + 1),
  // w = 2 sqrt(k / m) sin(q / 2). In steps of the time T Verlet's scheme swings at w' with
  // sin(w' T / 2) = w T / 2 exactly.
  using std::numbers::pi;
  constexpr std::size_t masses = 5;
  Simulation sim{moving(strong), row(masses + 1), rock_of(density)};
  const double q = pi / (2 * masses + 1);
  const double w = 2 * std::sqrt(k_n * area / mass) * std::sin(0.5 * q);
  const double amplitude = 0.01;  // of the velocity of the mode [m/s]
  for (BodyIndex i = 1; i <= masses; ++i) sim.set_velocity(i, {amplitude * std::sin(q * i), 0});
  const double turn = 2 * std::asin(0.5 * w * sim.time_step());  // w' T
  const auto steps = static_cast<int>(10 * 2 * pi / turn);       // ten periods
  for (int n = 0; n < steps; ++n) sim.step();
  for (BodyIndex i = 1; i <= masses; ++i) {
    // Velocities go with the cosine. Rounding of positions, 1e-16 of 0.5 m and 1e-10 of the
    // displacements, adds up over 1,000 steps.
    const double expected = amplitude * std::sin(q * i) * std::cos(turn * steps);
    CHECK(sim.particles().body(i).velocity.x() == near(expected, 1e-8 * amplitude));
  }
}

TEST_CASE("a cantilever of rigid cells bends as the chain of its elastic joints") {
  // Load P at the centroid of the last of N free cells, h apart: joint j has the moment
  // P h (N - j - 1/2), the rotation M 12 / (k_n t h^3), and every joint slides by P / (k_s h t).
  constexpr std::size_t cells = 4;
  Simulation sim{still(strong), row(cells + 1), rock_of(density)};
  const double load = 2e3;
  sim.set_load(cells, {0, -load});
  for (int n = 0; n < 60'000; ++n) sim.step();
  double lever = 0;
  for (std::size_t m = 0; m < cells; ++m)
    lever += (static_cast<double>(m) + 0.5) * (static_cast<double>(m) + 0.5);
  const double bent = 12 * load / (k_n * side) * lever;
  const double slid = static_cast<double>(cells) * load / (k_s * area);
  // Rotations of 4e-5 change the levers by their square.
  CHECK(sim.particles().body(cells).position.y() == near_relative(-(bent + slid), 1e-7));
  CHECK(sim.bond_force_on(0).force.y() == near_relative(-load, 1e-8));
  CHECK(sim.bond_force_on(0).moment ==
        near_relative(-load * side * static_cast<double>(cells), 1e-7));
}

TEST_CASE("a bar breaks at its strength, once, and both parts are told") {
  Watch watch;
  // Tensile strength 1 MPa in the middle of a bar that is pulled slowly at its other end.
  BrittleBond law = strong;
  law.tensile_strength = 1e6;
  Assembly assembly = row(5);
  assembly.particles[4].motion = Motion::prescribed;
  assembly.particles[4].velocity = {2e-4, 0};
  Simulation sim{still(law), assembly, rock_of(density)};
  const double at_strength = 4 * 1e6 / k_n;
  double largest = 0;
  while (watch.seen.empty() && sim.time() < 0.2) {
    largest = std::max(largest, sim.bond_force_on(0).force.x());
    sim.step(watch);
  }
  REQUIRE(watch.seen.size() == 1);
  const BondBreak& event = watch.seen[0];
  // The wave of the start, rho c v with c = sqrt(k_n h / rho), is 0.14 % of the strength.
  CHECK(largest == near_relative(1e6 * area, 2e-3));
  CHECK(2e-4 * sim.time() == near_relative(at_strength, 2e-3));
  CHECK(event.failure == BondFailure::tension);
  CHECK(event.step == sim.steps());
  CHECK(event.time == sim.time());
  CHECK(event.separates);
  CHECK(std::abs(event.place.x() / side - std::floor(event.place.x() / side) - 0.5) <= 1e-3);
  CHECK((event.ends[1] - event.ends[0]).norm() == near_relative(side, 1e-12));
  CHECK(event.length == near_relative(side, 1e-12));
  CHECK(event.energy == near_relative(0.5 * 1e12 / k_n * area, 4e-3));
  CHECK(event.particles[1] == event.particles[0] + 1);
  CHECK(sim.bond_breaks().size() == 1);
  for (int n = 0; n < 20'000; ++n) sim.step(watch);
  CHECK(sim.bonds().size() == 3);
  CHECK(sim.bond_force_on(0).force.norm() <= 1e-6 * 1e6 * area);
}

TEST_CASE("only the last bond between two parts separates them") {
  Assembly assembly = of({});
  for (const double x : {0.0, side})
    for (const double y : {0.0, side})
      assembly.particles.push_back({rectangle({x, y}, side, side)});
  REQUIRE(bond_common_edges(assembly) == 4);
  Simulation sim{still(strong), assembly, rock_of(density)};
  for (BodyIndex i = 0; i < 4; ++i) CHECK(sim.particles().ancestry(i).root == 0);
  while (!sim.bonds().empty())
    sim.break_bonds([first = sim.bonds()[0].b](const auto& bond) { return bond.b == first; });
  const std::vector<BondBreak>& breaks = sim.bond_breaks();
  REQUIRE(breaks.size() == 4);
  CHECK(std::count_if(breaks.begin(), breaks.end(),
                      [](const BondBreak& event) { return event.separates; }) == 3);
  CHECK_FALSE(breaks[0].separates);
  CHECK(breaks[0].failure == BondFailure::none);
}

TEST_CASE("a bond of dust separates a body that it leaves alone, and only the last one does") {
  // The right fifth of square 0 is dust, which comes off by that break. It takes both bonds with
  // square 1, which is alone then, and a part of that with square 2, which stays with the rest of
  // 0.
  const std::vector<Vec2> at{{0, 0}, {1, 0}, {0, 1}};
  Assembly assembly = of({});
  for (const Vec2& centre : at) assembly.particles.push_back({rectangle(centre, 1, 1)});
  assembly.bonds = {{.a = 0, .b = 1, .ends = {{{0.5, -0.5}, {0.5, 0}}}},
                    {.a = 0, .b = 1, .ends = {{{0.5, 0}, {0.5, 0.5}}}},
                    {.a = 0, .b = 2, .ends = {{{-0.5, 0.5}, {0.5, 0.5}}}}};
  Particles particles(1, density);
  for (const PlacedParticle& p : assembly.particles) particles.add(p.polygon, Motion::free);
  BondStage<BrittleBond, UnboundedDomain> stage{strong};
  stage.begin(assembly, particles, {});

  const Body whole = particles.body(0);
  const Ancestry ancestry = particles.ancestry(0);
  particles.replace(0, rectangle({-0.1, 0}, 0.8, 1), Motion::free, ancestry);
  const Line upwards{{0.3, 0}, {0, 1}};
  stage.divide({whole, 0, upwards, {BodyIndex{0}, std::nullopt}}, particles, {}, {});
  REQUIRE(stage.breaks.size() == 3);
  CHECK(stage.breaks[0].particles == stage.breaks[1].particles);
  CHECK_FALSE(stage.breaks[0].separates);
  CHECK(stage.breaks[1].separates);
  CHECK_FALSE(stage.breaks[2].separates);
  REQUIRE(stage.bonds.size() == 1);
  CHECK(stage.bonds[0].length == near_relative(0.8, 1e-12));
}

TEST_CASE("bonded bodies have no contact, and get it when the bond breaks") {
  // Pressed together: the bond carries it, then the contact, with no more force and no more energy.
  Assembly assembly = row(2);
  Simulation sim{Model{}
                     .criterion(NeverFails{})
                     .boundary(NoBoundary{})
                     .bond_law(strong)
                     .contact_law(EnergyConservingSpring{.normal_stiffness = 2e9}),
                 assembly, rock_of(density)};
  const double force = 1e4;
  sim.set_load(1, {-force, 0});
  for (int n = 0; n < 2000; ++n) sim.step();
  CHECK(sim.contacts().pairs().empty());
  CHECK(sim.bond_force_on(1).force.x() == near_relative(force, 1e-9));
  const double stored = stored_energy_of(sim);
  CHECK(stored == near_relative(0.5 * force * force / (k_n * area), 1e-8));

  sim.break_bonds([](const auto&) { return true; });
  CHECK(sim.bonds().empty());
  CHECK(sim.bond_force_on(1).force == Vec2{0, 0});
  const double pushing = sim.force_on(1).force.x();
  CHECK(pushing > 0);
  CHECK(pushing <= force * (1 + 1e-9));
  CHECK(stored_energy_of(sim) <= stored);
  CHECK(sim.bonds().loss() + stored_energy_of(sim) == near_relative(stored, 1e-12));
  for (int n = 0; n < 20'000; ++n) sim.step();
  CHECK(sim.force_on(1).force.x() == near_relative(force, 1e-6));
}

namespace {

// A cell pressed on a held one with `pressure`, and slid along it until the bond fails in shear.
template <ContactLaw Law>
void shear_under_pressure(const Law& contact, bool begins_with_less) {
  BrittleBond law = strong;
  law.cohesion = 1e6;
  law.friction = 0.5;
  const double pressure = 2e6;
  Assembly assembly = row(2);
  Simulation sim{Model{}
                     .criterion(NeverFails{})
                     .boundary(NoBoundary{})
                     .narrow_phase(OverlapChord{})
                     .bond_law(law)
                     .contact_law(contact),
                 assembly, rock_of(density)};
  sim.set_load(1, {-pressure * area, 0});
  for (int n = 0; n < 3000; ++n) sim.step();
  EnergyLedger ledger;
  ledger.open(sim);
  // Pushed at the height of its centroid: the far end of the edge is relieved by the moment.
  double push = 0;
  double pressing = 0;
  double stored = 0;
  while (sim.bond_breaks().empty() && push < 1e6) {
    push += 2;
    sim.set_load(1, {-pressure * area, push}, -0.5 * side * push);
    pressing = sim.bond_force_on(1).force.x();
    stored = stored_energy_of(sim);
    sim.step(ledger);
  }
  REQUIRE(sim.bond_breaks().size() == 1);
  const BondBreak& event = sim.bond_breaks()[0];
  CHECK(event.failure == BondFailure::shear);
  // The moment of the load makes the shear uniform: cohesion + friction * pressure.
  CHECK(push == near_relative((1e6 + 0.5 * pressure) * area, 5e-3));
  CHECK(event.energy + stored_energy_of(sim) + sim.contacts().friction_loss() ==
        near_relative(stored, 5e-3));
  if (begins_with_less) {
    CHECK(event.energy > 0);
    CHECK(stored_energy(sim.contacts()) <= stored);
    CHECK(sim.force_on(1).force.x() <= pressing * 1.01);
    CHECK(sim.force_on(1).force.x() > 0);
    // Coulomb's friction is left of the shear, or what the bond's energy allows.
    CHECK(std::abs(sim.force_on(1).force.y()) <= 0.5 * sim.force_on(1).force.x() * 1.001);
  }
  const EnergyTerms terms = ledger.terms(sim);
  CHECK(terms.bonds == near_relative(event.energy, 1e-12));
  CHECK(std::abs(terms.law_residual) <= 5e-3 * stored);
}

}  // namespace

TEST_CASE("a bond that fails in shear under pressure leaves its contact no more than it had") {
  // Softer and stiffer than the bond, whose stiffness is 2e10 N/m: with the offset of the law the
  // contact never begins with more.
  for (const double stiffness : {1e9, 2e10, 2e11})
    shear_under_pressure(
        EnergyConservingSpring{.normal_stiffness = stiffness, .tangential_stiffness = stiffness},
        true);
  // Without a history the contact has the whole force of the overlap; the difference is booked.
  for (const double stiffness : {1e9, 1e11}) shear_under_pressure(springs(stiffness, 0.5), false);
}

TEST_CASE("a run whose bonds are all broken at the start is one without bonds, to the byte") {
  Assembly bonded = of({{rectangle({0, -0.1}, 2, 0.1), Motion::wall}});
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j)
      bonded.particles.push_back({rectangle({side * i, side * j}, side, side),
                                  Motion::free,
                                  {0.3 * i, -0.2 * j},
                                  0.5 * j});
  std::vector<std::size_t> cells;
  for (std::size_t i = 1; i < bonded.particles.size(); ++i) cells.push_back(i);
  CHECK(bond_common_edges(bonded, cells) == 17);
  Assembly loose = bonded;
  loose.bonds.clear();
  const double time_step = 1e-5;
  Simulation with{still(strong), bonded, rock_of(density)};
  Simulation without{damped(springs(1e7, 0.5)), loose, rock_of(density)};
  with.set_time_step(time_step);
  without.set_time_step(time_step);
  with.break_bonds([](const auto&) { return true; });
  for (int n = 0; n < 2000; ++n) {
    with.step();
    without.step();
  }
  const std::vector<double> p = state_of(with.particles());
  const std::vector<double> q = state_of(without.particles());
  CHECK(p.size() == q.size());
  CHECK(std::memcmp(p.data(), q.data(), p.size() * sizeof(double)) == 0);
  CHECK(with.contacts().friction_loss() == without.contacts().friction_loss());
  CHECK(without.contacts().friction_loss() > 0);
}

TEST_CASE("a bar that breaks while it swings: the balance of energy closes") {
  BrittleBond law = strong;
  law.tensile_strength = 1e6;
  law.cohesion = 1e6;
  law.friction = 0.5;
  // The error of the trapezoid sum where a bond breaks is of the order of the step.
  double before = 0;
  for (const double share : {1.0, 0.25}) {
    Assembly assembly = row(8, Motion::free);
    for (std::size_t i = 0; i < 8; ++i)
      assembly.particles[i].velocity = {0.2 * static_cast<double>(i), i % 2 == 0 ? 0.1 : -0.1};
    Simulation sim{moving(law), assembly, rock_of(density)};
    sim.set_time_step(share * sim.time_step());
    EnergyLedger ledger;
    ledger.open(sim);
    const double start = kinetic_energy(sim.particles());
    while (sim.time() < 2e-3) sim.step(ledger);
    CHECK(sim.bond_breaks().size() >= 3);
    const EnergyTerms terms = ledger.terms(sim);
    double lost = 0;
    for (const BondBreak& event : sim.bond_breaks()) lost += event.energy;
    CHECK(terms.bonds == near_relative(lost, 1e-12));
    CHECK(terms.bonds > 1e-3 * start);
    CHECK(std::abs(terms.unclosed()) <= 1e-11 * start);
    const double residual = std::abs(terms.law_residual) / start;
    CHECK(residual <= 0.02);
    if (share < 1) CHECK(residual <= 0.5 * before);
    before = residual;
  }
}

TEST_CASE("a softening bar dissipates the fracture energy of its one broken bond") {
  const SofteningBond law{.normal_stiffness = k_n,
                          .tangential_stiffness = k_s,
                          .tensile_strength = 1e6,
                          .shear_strength = 1e6,
                          .fracture_energy = 40};
  Assembly assembly = row(3);
  assembly.particles[2].motion = Motion::prescribed;
  assembly.particles[2].velocity = {0.02, 0};
  assembly.bonds.pop_back();  // one bond between a held and a free cell, one to pull
  assembly.particles[1].motion = Motion::prescribed;
  assembly.particles[1].velocity = {0.02, 0};
  Simulation sim{still(law), assembly, rock_of(density)};
  sim.set_time_step(1e-6);
  EnergyLedger ledger;
  ledger.open(sim);
  while (sim.bond_breaks().empty() && sim.time() < 0.1) sim.step(ledger);
  REQUIRE(sim.bond_breaks().size() == 1);
  const EnergyTerms terms = ledger.terms(sim);
  CHECK(terms.bonds == near_relative(40 * area, 1e-12));
  // Pulled apart by a boundary: its work is the same, with the error of trapezoids at two kinks.
  CHECK(terms.boundary_work == near_relative(40 * area, 1e-3));
  CHECK(std::abs(terms.unclosed()) <= 1e-9 * terms.bonds);
  CHECK(0.02 * sim.time() == near_relative(2 * 40 / 1e6, 1e-3));
}

TEST_CASE("a free bonded row turns and flies without strain") {
  Assembly assembly = row(5, Motion::free);
  const double spin = 30;
  for (std::size_t i = 0; i < 5; ++i) {
    const double arm = side * (static_cast<double>(i) - 2);
    assembly.particles[i].velocity = {0.5, 1 + spin * arm};
    assembly.particles[i].angular_velocity = spin;
  }
  Simulation sim{moving(strong), assembly, rock_of(density)};
  const double energy = kinetic_energy(sim.particles());
  for (int n = 0; n < 3000; ++n) sim.step();
  // Centrifugal forces of m w^2 r strain the bonds; 2 % of their weight of 9.81 at 1 kHz sway.
  Vec2 momentum{0, 0};
  double moment = 0;
  for (const Body& body : sim.particles().bodies()) {
    momentum += body.mass * body.velocity;
    moment += body.inertia * body.angular_velocity +
              body.mass * cross(body.position - Vec2{2 * side, 0}, body.velocity);
  }
  CHECK((momentum - 5 * mass * Vec2{0.5, 1}).norm() <= 1e-11 * momentum.norm());
  // About the point where its centre started: of the spin alone.
  const double inertia = 5 * mass * side * side / 6 + mass * side * side * 10;
  const double offset = 5 * mass * cross(sim.time() * Vec2{0.5, 1}, Vec2{0.5, 1});
  CHECK(moment - offset == near_relative(spin * inertia, 1e-9));
  CHECK(kinetic_energy(sim.particles()) + stored_energy_of(sim) == near_relative(energy, 1e-3));
}

TEST_CASE("bodies may be added and removed beside bonds") {
  Simulation sim{still(strong), row(4, Motion::free), rock_of(density)};
  const ParticleId far = sim.add(rectangle({5, 5}, side, side));
  sim.step();
  CHECK(sim.bond_force_on(sim.index_of(far)).force == Vec2{0, 0});
  sim.remove(1);
  REQUIRE(sim.bonds().size() == 1);
  CHECK(sim.bonds()[0].a == 1);
  CHECK(sim.bonds()[0].b == 2);
  CHECK(sim.bond_breaks().empty());
  sim.step();
  CHECK(sim.contacts().pairs().size() == 0);
}

TEST_CASE("a bonded body may be held, but not become a wall") {
  Simulation sim{still(strong), row(3, Motion::free), rock_of(density)};
  const ParticleId far = sim.add(rectangle({5, 5}, side, side));
  const std::string rule = "particle 2: its bonds = 1: must be none for a wall or a platen; "
                           "Motion::prescribed holds it";
  for (const Motion motion : {Motion::wall, Motion::platen})
    CHECK(message_of([&] { sim.set_motion(2, motion); }) == rule);
  CHECK(sim.particles().body(2).motion == Motion::free);
  sim.set_motion(2, Motion::prescribed);
  sim.set_motion(sim.index_of(far), Motion::wall);
  // Clamped at one end.
  const Vec2 place = sim.particles().body(2).position;
  const double force = 1e5;
  sim.set_load(0, {-force, 0});
  for (int n = 0; n < 6000; ++n) sim.step();
  CHECK(sim.particles().body(2).position == place);
  CHECK(sim.bond_force_on(2).force.x() == near_relative(-force, 1e-9));
  sim.break_bonds([](const auto&) { return true; });
  sim.set_motion(2, Motion::wall);
  CHECK(sim.particles().body(2).is_wall());
}

TEST_CASE(
    "the time step is below 0.12 of the stability limit of the bonds, with contacts as well") {
  Simulation with{still(strong), row(6), rock_of(density)};
  Assembly loose = row(6);
  loose.bonds.clear();
  Simulation without{damped(springs(1e7, 0.5)), loose, rock_of(density)};
  CHECK(with.time_step() < without.time_step());
  // Gershgorin's bound for a square with bonds on two opposite edges; arms are those of the points
  // of Gauss's rule, at h / 2 across and h / (2 sqrt 3) along the edge.
  const double inertia = mass * side * side / 6;
  const double arm = side * side * (0.25 + 1.0 / 12);
  const double squared = 2 * 2 * k_n * area * (1 / mass + arm / inertia);
  const double stiffness = 0.25 * mass * squared + 1e7;
  CHECK(with.time_step() == near_relative(0.12 * std::sqrt(mass / stiffness), 1e-12));
}

TEST_CASE("a model without a bond law refuses bonds") {
  CHECK(message_of([] { Simulation sim(damped(springs(1e7, 0)), row(2), rock_of(density)); }) ==
        "Assembly.bonds is not empty: give the model a bond_law");
}
