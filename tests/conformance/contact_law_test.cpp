// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <support/violated.hpp>

#include <riprap/conformance/contact_law.hpp>
#include <riprap/contact/contact_law/contact_law_choice.hpp>
#include <riprap/contact/contact_law/energy_conserving_spring.hpp>
#include <riprap/contact/contact_law/incremental_spring.hpp>
#include <riprap/contact/contact_law/linear_spring_coulomb.hpp>
#include <riprap/contact/contact_law/no_contact_force.hpp>
#include <riprap/contact/contact_law/overlap_area_spring.hpp>
#include <riprap/contact/contact_law/spring_dashpot.hpp>

using namespace riprap;
using test::check_violated;

namespace {

struct HertzianSpring {
  double stiffness = 1e9;
  double deepest = 1e-4;
  struct History {};
  ContactForce operator()(const ContactGeometry& at, const ContactMotion&, History&) const {
    return {.normal = stiffness * at.depth * std::sqrt(at.depth) * at.depth_gradient};
  }
  double stored_energy(const ContactGeometry& at, const History&) const {
    return 0.4 * stiffness * at.depth * at.depth * std::sqrt(at.depth);
  }
  double peak_stiffness() const { return 1.5 * stiffness * std::sqrt(deepest); }
  void validate() const {}
};

/// The default law with one thing wrong about its force.
template <class Change>
struct Altered : LinearSpringCoulomb {
  Change change;
  ContactForce operator()(const ContactGeometry& geometry, const ContactMotion& motion,
                          History& history) const {
    ContactForce force = LinearSpringCoulomb::operator()(geometry, motion, history);
    change(force, geometry, motion);
    return force;
  }
};

template <class Change>
Violations violations_of(Change change) {
  return contact_law_violations(Altered<Change>{{}, change});
}

struct NegativeEnergy : LinearSpringCoulomb {
  double stored_energy(const ContactGeometry& geometry, const History& history) const {
    return -LinearSpringCoulomb::stored_energy(geometry, history);
  }
};

struct WithoutStiffness : NoContactForce {
  double peak_stiffness() const { return 0; }
};

/// Has negative normal forces, and no member `may_pull`.
struct SecretlyPulling {
  using History = SpringDashpot::History;
  SpringDashpot law{.may_pull = true};
  ContactForce operator()(const ContactGeometry& geometry, const ContactMotion& motion,
                          History& history) const {
    return law(geometry, motion, history);
  }
  double stored_energy(const ContactGeometry& geometry, const History& history) const {
    return law.stored_energy(geometry, history);
  }
  double peak_stiffness() const { return law.peak_stiffness(); }
  void validate() const {}
};

/// Takes no notice of how fast the depth grows.
struct WithoutGradient : LinearSpringCoulomb {
  ContactForce operator()(const ContactGeometry& geometry, const ContactMotion& motion,
                          History& history) const {
    ContactGeometry plain = geometry;
    plain.depth_gradient = 1;
    return LinearSpringCoulomb::operator()(plain, motion, history);
  }
};

/// Its friction does not follow the member `friction`.
struct StuckFriction : LinearSpringCoulomb {
  ContactForce operator()(const ContactGeometry& geometry, const ContactMotion& motion,
                          History& history) const {
    return LinearSpringCoulomb{}(geometry, motion, history);
  }
};

/// Whose contacts begin after a bond with another force.
template <class Change>
struct AfterBond : EnergyConservingSpring {
  Change change;
  History history_after_bond(const ContactGeometry& geometry, const FormerBond& bond) const {
    History history = EnergyConservingSpring::history_after_bond(geometry, bond);
    change(history, bond);
    return history;
  }
};

template <class Change>
Violations violations_after_bond(Change change) {
  return contact_law_violations(AfterBond<Change>{{}, change});
}

}  // namespace

TEST_CASE("the contact laws of riprap obey the axioms") {
  CHECK(to_text(contact_law_violations(LinearSpringCoulomb{})) == "");
  CHECK(to_text(contact_law_violations(LinearSpringCoulomb{.tangential_stiffness = 0})) == "");
  CHECK(to_text(contact_law_violations(SpringDashpot{})) == "");
  CHECK(to_text(contact_law_violations(SpringDashpot{.may_pull = true})) == "");
  CHECK(to_text(contact_law_violations(SpringDashpot{.damping_ratio = 0.9})) == "");
  CHECK(to_text(contact_law_violations(OverlapAreaSpring{})) == "");
  // So deep that the corner's chord is the longest, too.
  CHECK(to_text(contact_law_violations(OverlapAreaSpring{}, {.deepest = 0.008})) == "");
  CHECK(to_text(contact_law_violations(EnergyConservingSpring{})) == "");
  CHECK(to_text(contact_law_violations(IncrementalSpring{})) == "");
  CHECK(to_text(contact_law_violations(NoContactForce{})) == "");
}

TEST_CASE("a choice of contact laws obeys the axioms with each of them") {
  using Choice = ContactLawChoice<LinearSpringCoulomb, SpringDashpot, OverlapAreaSpring,
                                  EnergyConservingSpring, IncrementalSpring, NoContactForce>;
  CHECK(to_text(contact_law_violations(Choice{LinearSpringCoulomb{}})) == "");
  CHECK(to_text(contact_law_violations(Choice{SpringDashpot{}})) == "");
  CHECK(to_text(contact_law_violations(Choice{OverlapAreaSpring{}})) == "");
  CHECK(to_text(contact_law_violations(Choice{EnergyConservingSpring{}})) == "");
  CHECK(to_text(contact_law_violations(Choice{IncrementalSpring{}})) == "");
  CHECK(to_text(contact_law_violations(Choice{NoContactForce{}})) == "");
  // A choice has no member that says so.
  const Violations pulling = contact_law_violations(Choice{SpringDashpot{.may_pull = true}});
  check_violated(pulling, "a contact never pulls");
  CHECK(pulling.size() == 1);
}

TEST_CASE("a user's contact law obeys the axioms as deep as it is meant for") {
  CHECK(to_text(contact_law_violations(HertzianSpring{})) == "");
  check_violated(contact_law_violations(HertzianSpring{}, {.deepest = 2e-4}),
                 "the force rises no faster than by the peak stiffness");
}

TEST_CASE("a contact law with forces at no depth is reported") {
  check_violated(violations_of([](auto& f, auto&, auto&) { f.normal += 1; }),
                 "no depth, no normal force");
  check_violated(violations_of([](auto& f, auto&, auto&) { f.tangential += 1; }),
                 "no depth, no tangential force");
}

TEST_CASE("a contact law stiffer than its peak stiffness is reported") {
  check_violated(violations_of([](auto& f, auto&, auto&) { f.normal *= 1.01; }),
                 "the force rises no faster than by the peak stiffness");
  check_violated(contact_law_violations(WithoutStiffness{}), "the peak stiffness is above zero");
}

TEST_CASE("a contact law with tension or too much shear is reported") {
  check_violated(contact_law_violations(SecretlyPulling{}), "a contact never pulls");
  check_violated(violations_of([](auto& f, auto&, auto&) { f.tangential *= 1.01; }),
                 "shear is at most friction times the normal force");
  check_violated(contact_law_violations(StuckFriction{}),
                 "shear is at most friction times the normal force");
}

TEST_CASE("a contact law that makes energy, or loses more than it books, is reported") {
  check_violated(violations_of([](auto& f, auto&, auto&) { f.friction_loss = -f.friction_loss; }),
                 "slip never gives energy");
  check_violated(violations_of([](auto& f, auto&, auto&) { f.viscous_loss = -1e-12; }),
                 "dashpots never give energy");
  check_violated(contact_law_violations(NegativeEnergy{}), "stored energy is never negative");
  const std::string_view balance =
      "work done on a contact is stored, slipped or damped: the rest [J]";
  check_violated(violations_of([](auto& f, auto&, auto&) { f.normal *= 0.95; }), balance);
  check_violated(violations_of([](auto& f, auto&, auto&) { f.friction_loss *= 0.95; }), balance);
  check_violated(violations_of([](auto& f, auto&, auto& m) {
                   if (m.normal_velocity > 0) f.normal *= 0.9;
                 }),
                 balance);
  check_violated(contact_law_violations(WithoutGradient{}), balance);
}

TEST_CASE("a contact law that changes something in a time step of zero is reported") {
  check_violated(violations_of([](auto& f, auto&, auto& m) {
                   if (m.time_step == 0) f.normal *= 0.999;
                 }),
                 "without time the normal force stays");
  check_violated(violations_of([](auto& f, auto&, auto& m) {
                   if (m.time_step == 0) f.tangential *= 0.999;
                 }),
                 "without time the tangential force stays");
  check_violated(violations_of([](auto& f, auto&, auto& m) {
                   if (m.time_step == 0) f.friction_loss = 1e-12;
                 }),
                 "without time nothing is lost");
}

TEST_CASE("a contact law that depends on body order, axes or handedness is reported") {
  check_violated(violations_of([](auto& f, auto& g, auto&) {
                   if (g.normal.x() < 0) f.normal *= 0.999;
                 }),
                 "swapped bodies feel the opposite force");
  check_violated(violations_of([](auto& f, auto& g, auto&) { f.normal *= std::abs(g.normal.y()); }),
                 "a contact moved and turned has the same force");
  check_violated(violations_of([](auto& f, auto& g, auto&) { f.normal *= 1 - g.point.x(); }),
                 "a contact moved and turned has the same force");
  check_violated(
      violations_of([](auto& f, auto&, auto&) { f.tangential = std::max(f.tangential, 0.0); }),
      "a mirrored contact has the mirrored force");
}

TEST_CASE("a contact law whose contacts begin with more than a bond had is reported") {
  CHECK(violations_after_bond([](auto&, auto&) {}).empty());
  // The whole force of the overlap.
  const Violations whole = violations_after_bond([](auto& h, auto&) { h.offset = 0; });
  check_violated(whole, "after a bond a contact stores at most the bond's energy");
  check_violated(whole, "after a bond a contact pushes at most as the bond did");
  CHECK(whole.size() == 2);
  check_violated(violations_after_bond(
                     [](auto& h, auto& bond) { h.tangential_force = bond.tangential_force; }),
                 "after a bond a contact stores at most the bond's energy");
  check_violated(
      violations_after_bond([](auto& h, auto&) { h.tangential_force = -h.tangential_force; }),
      "after a bond a contact shears in the bond's direction");
  check_violated(violations_after_bond([](auto& h, auto& bond) {
                   h.tangential_force = 1.01 * bond.tangential_force;
                 }),
                 "after a bond a contact shears at most as the bond did");
}

TEST_CASE("contact laws give the same in millimetres, grams and milliseconds") {
  CHECK(to_text(contact_law_unit_violations(
            EnergyConservingSpring{},
            EnergyConservingSpring{.normal_stiffness = 2e4, .tangential_stiffness = 2e4})) == "");
  CHECK(to_text(contact_law_unit_violations(
            IncrementalSpring{},
            IncrementalSpring{.normal_stiffness = 2e4, .tangential_stiffness = 2e4})) == "");
  CHECK(to_text(contact_law_unit_violations(
            LinearSpringCoulomb{},
            LinearSpringCoulomb{.normal_stiffness = 2e4, .tangential_stiffness = 2e4})) == "");
  CHECK(to_text(contact_law_unit_violations(
            SpringDashpot{},
            SpringDashpot{.normal_stiffness = 2e4, .tangential_stiffness = 2e4})) == "");
  CHECK(to_text(contact_law_unit_violations(OverlapAreaSpring{},
                                            OverlapAreaSpring{.area_stiffness = 6e2,
                                                              .tangential_stiffness = 2e4,
                                                              .largest_chord = 16})) == "");
  CHECK(to_text(contact_law_unit_violations(
            HertzianSpring{},
            HertzianSpring{.stiffness = 1e9 * std::pow(1e3, -1.5), .deepest = 0.1})) == "");
}

// A time step needs some stiffness, and without forces any will do.
TEST_CASE("NoContactForce has a peak stiffness of its own, and nothing else") {
  const Violations violations = contact_law_unit_violations(NoContactForce{}, NoContactForce{});
  check_violated(violations, "the peak stiffness is the same in other units");
  CHECK(violations.size() == 1);
}

TEST_CASE("a contact law with numbers of its own is reported in other units") {
  const Violations unchanged =
      contact_law_unit_violations(LinearSpringCoulomb{}, LinearSpringCoulomb{});
  check_violated(unchanged, "the peak stiffness is the same in other units");
  check_violated(unchanged, "the normal force is the same in other units");
  check_violated(unchanged, "stored energy is the same in other units");
  check_violated(contact_law_unit_violations(
                     LinearSpringCoulomb{},
                     LinearSpringCoulomb{.normal_stiffness = 2e4, .tangential_stiffness = 2e7}),
                 "the tangential force is the same in other units");
}
