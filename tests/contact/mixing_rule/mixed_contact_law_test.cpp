// SPDX-License-Identifier: BSL-1.0
#include <riprap/contact/mixing_rule/mixed_contact_law.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include <riprap/bond/bond_law/brittle_bond.hpp>
#include <riprap/contact/contact_law/contact_law_choice.hpp>
#include <riprap/contact/contact_law/no_contact_force.hpp>
#include <riprap/contact/contact_law/spring_dashpot.hpp>
#include <riprap/contact/mixing_rule/friction_of_pairs.hpp>
#include <riprap/measurement/energy.hpp>
#include <riprap/measurement/energy_ledger.hpp>
#include <riprap/particle/bond_common_edges.hpp>
#include <riprap/simulation/simulation.hpp>
#include <support/crushing.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/rectangle.hpp>
#include <support/same_run.hpp>
#include <support/unbreakable.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

using Mixed = MixedContactLaw<LinearSpringCoulomb>;
static_assert(ContactLaw<Mixed> && FrictionalLaw<Mixed>);
static_assert(
    ContactLaw<MixedContactLaw<NoContactForce, decltype([](const auto& law, const auto&,
                                                           const MaterialPair&) { return law; })>>);

const EnergyConservingSpring stiff{.normal_stiffness = 4e7, .friction = 0.6};
const EnergyConservingSpring soft{.normal_stiffness = 1e7, .friction = 0.3};
const Rocks two{Rock{}, Rock{.density = 2200, .strength_factor = 0.3}};

}  // namespace

TEST_CASE("equal laws run to the same bytes as the law itself, breaks included") {
  const auto one = run_of(Model{}, 1500);
  const EnergyConservingSpring law;
  CHECK(same_bytes(run_of(Model{}.contact_law(MixedContactLaw{{law}}), 1500), one));
  const Rocks same{Rock{}, Rock{}};
  const auto both = Model{}.contact_law(MixedContactLaw{{law, law}});
  CHECK(same_bytes(run_of(both, 1500, same, {0, 1, 1, 0}), one));
  CHECK(same_bytes(run_of(both.without_acceleration(), 1500, same, {1, 0, 1, 1}), one));
}

TEST_CASE("a contact has the law of its two materials") {
  const Mixed law{{springs(1e7, 0.6), springs(3e7, 0.2)}};
  CHECK(law.materials() == 2);
  CHECK(law.of(0, 0).normal_stiffness == 1e7);
  CHECK(law.of(1, 1).friction == 0.2);
  CHECK(law.of(0, 1).normal_stiffness == near_relative(1.5e7, 1e-15));
  CHECK(law.of(1, 0).normal_stiffness == law.of(0, 1).normal_stiffness);
  CHECK(law.peak_stiffness() == 3e7);
  const ContactGeometry geometry{.depth = 1e-4};
  Mixed::History history;
  ContactMotion motion{.tangential_velocity = 100, .time_step = 1, .material_b = 1};
  const ContactForce force = law(geometry, motion, history);
  CHECK(force.normal == near_relative(1500, 1e-14));
  CHECK(force.tangential == near_relative(-0.2 * 1500, 1e-14));
  CHECK(law.stored_energy(geometry, history) ==
        near_relative(0.5 * 1.5e7 * 1e-8 + 0.5 * 300 * 300 / 1.5e7, 1e-14));
  motion = {.material_a = 1, .material_b = 1};
  CHECK(law(geometry, motion, history).normal == near_relative(3000, 1e-14));
}

TEST_CASE("without friction, or with another one, all pairs have it") {
  const MixedContactLaw law{{springs(1e7, 0.6), springs(3e7, 0.2)},
                            FrictionOfPairs<>{.table = {{0, 1, 0.5}}}};
  CHECK(law.of(0, 1).friction == 0.5);
  const auto smooth = frictionless(law);
  const auto other = with_friction(law, 0.1);
  for (MaterialIndex a = 0; a < 2; ++a)
    for (MaterialIndex b = 0; b < 2; ++b) {
      CHECK(smooth.of(a, b).friction == 0);
      CHECK(other.of(a, b).friction == 0.1);
      CHECK(other.of(a, b).normal_stiffness == law.of(a, b).normal_stiffness);
    }
}

TEST_CASE("a block is pressed by the springs of its rock and of the wall in series") {
  const double depth = 1e-4;
  for (MaterialIndex wall = 0; wall < 3; ++wall) {
    Assembly assembly = of({{rectangle({0, -1}, 40, 2), Motion::wall},
                            {rectangle({0, 1 - depth}, 10, 2), Motion::free}});
    assembly.particles[0].material = wall;
    const double other[] = {1e8, 4e8, 0.25e8};
    const Mixed law{{springs(other[0], 0), springs(other[1], 0), springs(other[2], 0)}};
    const Simulation sim{undamped(law), assembly, Rocks{rock_of(1), rock_of(2), rock_of(3)}};
    const double series = 2 / (1 / other[0] + 1 / other[wall]);
    CHECK(sim.force_on(1).force.y() == near_relative(series * depth, 1e-9));
  }
}

TEST_CASE("a block slides down a wall with the friction of the two materials") {
  const double slope = std::numbers::pi / 6;
  const double k = 1e10;
  const double gravity = 9.81;
  const double normal = 20 * 2000 * gravity * std::cos(slope);
  const Rotation turn = Rotation::from_angle(-slope);
  // On a wall of material 1. The sides of the block lean, so that the reaction with its friction
  // passes through the centroid.
  const auto acceleration = [&](const auto& law, double friction) {
    const double low = -normal / k;
    const double shift = -2 * friction;
    const ConvexPolygon block{{-5, low}, {5, low}, {5 + shift, 2 + low}, {-5 + shift, 2 + low}};
    Assembly assembly = of({{rectangle({20, -1}, 100, 2).moved(turn, {0, 0}), Motion::wall},
                            {block.moved(turn, {0, 0}), Motion::free, turn * Vec2{1, 0}}});
    assembly.particles[0].material = 1;
    Simulation sim{undamped(law), assembly, Rocks{rock_of(2000), rock_of(9)}};
    sim.set_body_force({0, -gravity});
    // In the first step there is no friction yet; the spin it leaves is taken away.
    sim.step();
    sim.set_velocity(1, sim.particles().body(1).velocity);
    const Body start = sim.particles().body(1);
    const double begin = sim.time();
    EnergyLedger ledger;
    ledger.open(sim);
    while (sim.time() < 1) sim.step(ledger);
    const EnergyTerms terms = ledger.terms(sim);
    CHECK(std::abs(terms.unclosed()) <= 1e-3 * terms.body_force_work);
    const Vec2 gained = turn.inverse_times(sim.particles().body(1).velocity - start.velocity);
    return gained.x() / (sim.time() - begin);
  };
  const auto closed_form = [&](double friction) {
    return near_relative(gravity * (std::sin(slope) - friction * std::cos(slope)), 1e-3);
  };
  // Of the block 0.55, of the wall 0.3: the smaller one; and a table that says otherwise. The
  // contact swings about its depth, and forces with it.
  const std::vector<LinearSpringCoulomb> laws{springs(k, 0.55), springs(k, 0.3)};
  CHECK(acceleration(MixedContactLaw{laws}, 0.3) == closed_form(0.3));
  const FrictionOfPairs<> table{.table = {{0, 1, 0.1}}};
  CHECK(acceleration(MixedContactLaw{laws, table}, 0.1) == closed_form(0.1));
}

TEST_CASE("stored energy is that of each contact's own pair, and the balance closes, with breaks") {
  const MixedContactLaw law{{stiff, soft}};
  Assembly assembly = square_between_platens(0.2);
  assembly.particles[0].material = 1;
  Simulation sim{Model{}.boundary(NoBoundary{}).contact_law(law), assembly, two};
  EnergyLedger ledger;
  ledger.open(sim);
  for (int i = 0; i < 3000 && sim.breaks().size() < 2; ++i) sim.step(ledger);
  for (int i = 0; i < 20; ++i) sim.step(ledger);
  REQUIRE_FALSE(sim.breaks().empty());
  double own = 0;
  int touching = 0;
  sim.contacts().for_each_touching([&](const auto& c) {
    const auto& of_pair = law.of(sim.particles().material(c.a), sim.particles().material(c.b));
    own += of_pair.stored_energy(c.geometry, c.history.own);
    CHECK(std::abs(c.force.tangential) <= of_pair.friction * c.force.normal * (1 + 1e-12));
    ++touching;
  });
  CHECK(touching > 0);
  CHECK(stored_energy(sim.contacts()) == near_relative(own, 1e-12));
  const EnergyTerms terms = ledger.terms(sim);
  CHECK(terms.made() <= 0.01 * terms.boundary_work);
}

namespace {

// Two bonded squares of one material, the first held, the second pressed and sheared, part: what is
// lost, what is stored and the force of the contact that begins.
template <ContactLaw Law>
std::vector<double> parting(const Law& law, const Rocks& rocks, MaterialIndex material) {
  Assembly pair = of({});
  for (const double x : {0.0, 0.1})
    pair.particles.push_back({.polygon = rectangle({x, 0}, 0.1, 0.1),
                              .motion = x > 0 ? Motion::free : Motion::prescribed,
                              .material = material});
  bond_common_edges(pair);
  const BrittleBond bond{.normal_stiffness = 2e11,
                         .tangential_stiffness = 1e11,
                         .tensile_strength = 1e30,
                         .cohesion = 1e30};
  Simulation sim{
      Model{}.criterion(NeverFails{}).boundary(NoBoundary{}).bond_law(bond).contact_law(law), pair,
      rocks};
  sim.set_time_step(1e-5);
  sim.set_load(1, {-1e4, 2e3});
  for (int n = 0; n < 3000; ++n) sim.step();
  const double stored = stored_energy_of(sim);
  sim.break_bonds([](const auto&) { return true; });
  // With this law no energy comes out of a break, and none is lost unbooked.
  CHECK(sim.bonds().loss() + stored_energy_of(sim) + sim.contacts().friction_loss() ==
        near_relative(stored, 1e-12));
  return {sim.bonds().loss(), stored_energy_of(sim), sim.force_on(1).force.x(),
          sim.force_on(1).force.y()};
}

}  // namespace

TEST_CASE("a contact that takes the place of a bond begins by the law of its materials") {
  const Rocks same{Rock{}, Rock{}};
  const MixedContactLaw law{{soft, stiff}};
  CHECK(parting(law, same, 0) == parting(soft, Rock{}, 0));
  CHECK(parting(law, same, 1) == parting(stiff, Rock{}, 0));
  CHECK(parting(soft, Rock{}, 0) != parting(stiff, Rock{}, 0));
  // Without a function for it a contact begins anew, by the law of its materials as well.
  const LinearSpringCoulomb weak{.normal_stiffness = 1e8};
  const LinearSpringCoulomb strong{.normal_stiffness = 3e8};
  CHECK(parting(MixedContactLaw{{weak, strong}}, same, 1) == parting(strong, Rock{}, 0));
}

TEST_CASE("two materials without losses keep their energy") {
  const double k = 1e4;
  std::vector<PlacedParticle> bodies{{rectangle({0, -4}, 8, 1), Motion::prescribed},
                                     {rectangle({0, 4}, 8, 1), Motion::prescribed},
                                     {rectangle({-4, 0}, 1, 9), Motion::prescribed},
                                     {rectangle({4, 0}, 1, 9), Motion::prescribed}};
  for (int i = 0; i < 9; ++i)
    bodies.push_back({rectangle({-2 + 2 * (i % 3), -2 + 2 * (i / 3)}, 1, 0.9 - 0.05 * i),
                      Motion::free, Vec2{0.4 * std::cos(i), 0.4 * std::sin(2.0 * i)}});
  for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].material = i % 2;
  const EnergyConservingSpring hard{
      .normal_stiffness = k, .tangential_stiffness = k, .friction = 0};
  const EnergyConservingSpring weak{
      .normal_stiffness = 0.1 * k, .tangential_stiffness = k, .friction = 0};
  Simulation sim{undamped(MixedContactLaw{{hard, weak}}).narrow_phase(OverlapMoments{}), of(bodies),
                 Rocks{rock_of(1), rock_of(3)}};
  sim.set_time_step(0.02 * std::sqrt(sim.smallest_mass() / k));
  const auto energy = [&] {
    return kinetic_energy(sim.particles()) + stored_energy(sim.contacts());
  };
  const double before = energy();
  double most = 0;
  for (int i = 0; i < 20'000; ++i) {
    sim.step();
    most = std::max(most, std::abs(energy() / before - 1));
  }
  // Second order in the step while a contact lasts: (0.02)^2 of what contacts hold.
  CHECK(most < 2e-3);
}

TEST_CASE("laws that break a rule are named, and so is a number of rocks that does not fit") {
  CHECK(message_of([] { (void)Mixed(std::vector<LinearSpringCoulomb>{}); }) ==
        "MixedContactLaw: the list of laws is empty");
  CHECK(message_of([] {
          Mixed{{springs(1e7, 0.5), springs(1e7, -1)}}.validate();
        }) ==
        "contact law of material 1: LinearSpringCoulomb.friction = -1: must be a finite number, 0 "
        "or above");
  CHECK(
      message_of([] {
        MixedContactLaw{{springs(1e7, 0.5)}, FrictionOfPairs<>{.table = {{0, 3, 0.1}}}}.validate();
      }) == "MixedContactLaw: materials of the rule = 4: must be at most those of the laws, 1");
  const auto refused = [](const auto& law) {
    return message_of([&] {
      Simulation sim{Model{}.boundary(NoBoundary{}).contact_law(law), square_between_platens(0),
                     Rock{}};
    });
  };
  const std::string message = "contact law: number of materials = 2: must be that of the rocks, 1";
  const MixedContactLaw both{{springs(1e7, 0.5), springs(1e7, 0.4)}};
  CHECK(refused(both) == message);
  using Choice = ContactLawChoice<Mixed, SpringDashpot>;
  CHECK(refused(Choice{both}) == message);
  CHECK(refused(Choice{SpringDashpot{}}).empty());
}
