// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the contact law.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string_view>
#include <utility>
#include <variant>

#include <riprap/conformance/collision.hpp>
#include <riprap/conformance/units.hpp>
#include <riprap/conformance/violations.hpp>
#include <riprap/contact/contact_law/concepts.hpp>
#include <riprap/contact/contact_law/contact_law_choice.hpp>
#include <riprap/contact/contact_law/frictionless.hpp>
#include <riprap/contact/mixing_rule/mixed_contact_law.hpp>

namespace riprap {
namespace internal {

template <class Law>
[[nodiscard]] bool may_pull(const Law& law) {
  if constexpr (requires { law.may_pull; })
    return law.may_pull;
  else
    return false;
}

/// At rest: no depth no force, and no slope above the peak stiffness.
template <ContactLaw Law>
void check_contact_at_rest(const Law& law, const ContactRange& range, AxiomCheck& check) {
  const double round_off = 1e-12 * law.peak_stiffness() * range.deepest;
  const auto force = [&](bool corner, double depth) -> ContactForce {
    typename Law::History history{};
    return law(contact_of(range, corner, depth), {.effective_mass = range.effective_mass}, history);
  };
  check.at_least("the peak stiffness is above zero", law.peak_stiffness(),
                 std::numeric_limits<double>::min());
  constexpr int samples = 64;
  for (const bool corner : {false, true}) {
    const ContactForce nothing = force(corner, 0);
    check.equal("no depth, no normal force", nothing.normal, 0, round_off);
    check.equal("no depth, no tangential force", nothing.tangential, 0, round_off);
    const double rise = range.deepest / samples;
    for (int i = 0; i < samples; ++i) {
      check.at("depth", i * rise);
      check.at_most("the force rises no faster than by the peak stiffness",
                    (force(corner, (i + 1) * rise).normal - force(corner, i * rise).normal) / rise,
                    law.peak_stiffness() * (1 + 1e-9));
    }
  }
}

/// During a collision: signs, friction, re-evaluation, energy.
template <ContactLaw Law>
void check_collision(const Law& law, const ContactRange& range, bool corner, AxiomCheck& check) {
  const double large = law.peak_stiffness() * range.deepest;
  typename Law::History history{};
  ContactForce before{};
  double work = 0;         // done on the contact [J]
  double lost = 0;         // [J]
  double energy = 0;       // the most that was stored and lost [J]
  double unexplained = 0;  // the most that work differed from it [J]
  visit_collision(range, corner, collision_time(law, range), [&](const CollisionInstant& now) {
    const ContactForce force = law(now.geometry, now.motion, history);
    const double stored = law.stored_energy(now.geometry, history);
    check.at("depth", now.geometry.depth);
    if (!may_pull(law)) check.at_least("a contact never pulls", force.normal, 0);
    if constexpr (requires { law.friction; })
      check.at_most("shear is at most friction times the normal force", std::abs(force.tangential),
                    law.friction * std::max(force.normal, 0.0) + 1e-12 * large);
    check.at_least("slip never gives energy", force.friction_loss, 0);
    check.at_least("dashpots never give energy", force.viscous_loss, 0);
    check.at_least("stored energy is never negative", stored, 0);

    ContactMotion still = now.motion;
    still.time_step = 0;
    const ContactForce again = law(now.geometry, still, history);
    check.equal("without time the normal force stays", again.normal, force.normal, 1e-12 * large);
    check.equal("without time the tangential force stays", again.tangential, force.tangential,
                1e-12 * large);
    check.equal("without time nothing is lost", again.friction_loss + again.viscous_loss, 0, 0);

    work -= 0.5 * now.motion.time_step *
            ((before.normal + force.normal) * now.motion.normal_velocity +
             (before.tangential + force.tangential) * now.motion.tangential_velocity);
    lost += force.friction_loss + force.viscous_loss;
    energy = std::max(energy, stored + lost);
    unexplained = std::max(unexplained, std::abs(stored + lost - work));
    before = force;
  });
  // A dashpot is booked with the force at the end of a step: an error of the first order.
  check.at_most("work done on a contact is stored, slipped or damped: the rest [J]", unexplained,
                20.0 / collision_steps * energy);
}

/// A collision seen from elsewhere gives the same force.
template <ContactLaw Law>
void check_contact_symmetry(const Law& law, const ContactRange& range, AxiomCheck& check) {
  const double round_off = 1e-12 * law.peak_stiffness() * range.deepest;
  typename Law::History history{}, of_swapped{}, of_moved{}, of_mirrored{};
  visit_collision(range, false, collision_time(law, range), [&](const CollisionInstant& now) {
    const ContactForce force = law(now.geometry, now.motion, history);
    const auto same = [&](std::string_view axiom, const ContactForce& other, double side) {
      check.equal(axiom, other.normal, force.normal, round_off);
      check.equal(axiom, side * other.tangential, force.tangential, round_off);
    };
    // Normal, tangent and relative velocity turn round together.
    ContactGeometry swapped = now.geometry;
    swapped.normal = -swapped.normal;
    same("swapped bodies feel the opposite force", law(swapped, now.motion, of_swapped), 1);

    ContactGeometry moved = now.geometry;
    const Rotation turn = Rotation::from_angle(2.1);
    moved.normal = turn * moved.normal;
    moved.point = turn * moved.point + Vec2{3, -5} * range.longest_chord;
    same("a contact moved and turned has the same force", law(moved, now.motion, of_moved), 1);

    ContactMotion mirrored = now.motion;
    mirrored.tangential_velocity = -mirrored.tangential_velocity;
    same("a mirrored contact has the mirrored force", law(now.geometry, mirrored, of_mirrored), -1);
  });
}

/// A contact in the place of a bond, softer or stiffer than the law, whose edges overlapped more or
/// less than the bodies do: no more force and no more energy than the bond had. Laws without
/// `history_after_bond` begin with a new contact.
template <ContactLaw Law>
void check_after_bond(const Law& law, const ContactRange& range, AxiomCheck& check) {
  if constexpr (requires(const ContactGeometry& at, const FormerBond& bond) {
                  law.history_after_bond(at, bond);
                }) {
    const double large = law.peak_stiffness() * range.deepest;
    constexpr double most = 1 + 1e-9;
    const auto begin = [&](const ContactGeometry& at, double pressing, double shearing,
                           double compliance) {
      const FormerBond bond{.normal_force = pressing,
                            .normal_energy = 0.5 * compliance * pressing * pressing,
                            .tangential_force = shearing,
                            .tangential_energy = 0.5 * compliance * shearing * shearing};
      typename Law::History history = law.history_after_bond(at, bond);
      check.at("depth", at.depth);
      check.at_most("after a bond a contact stores at most the bond's energy",
                    law.stored_energy(at, history),
                    most * (bond.normal_energy + bond.tangential_energy));
      const ContactForce force = law(at, {.effective_mass = range.effective_mass}, history);
      check.at_most("after a bond a contact pushes at most as the bond did", force.normal,
                    most * pressing + 1e-12 * large);
      const double share = force.tangential / shearing;
      check.at_least("after a bond a contact shears in the bond's direction", share, 0);
      check.at_most("after a bond a contact shears at most as the bond did", share, most);
    };
    for (const bool corner : {false, true})
      for (const double depth : {0.01 * range.deepest, 0.3 * range.deepest, range.deepest})
        for (const double pressing : {0.0, 0.1 * large, large})
          for (const double shearing : {-2 * large, -0.01 * large, 0.01 * large, 2 * large})
            for (const double softness : {0.01, 1.0, 100.0})
              begin(contact_of(range, corner, depth, std::numbers::sqrt2), pressing, shearing,
                    softness / law.peak_stiffness());
  }
}
template <ContactLaw... Laws>
void check_after_bond(const ContactLawChoice<Laws...>& law, const ContactRange& range,
                      AxiomCheck& check);
/// Of the law of two bodies of material 0, as which all contacts here are evaluated.
template <ContactLaw Law, class Rule>
void check_after_bond(const MixedContactLaw<Law, Rule>& law, const ContactRange& range,
                      AxiomCheck& check) {
  check_after_bond(law.of(0, 0), range, check);
}
/// Of the chosen one, which may be without.
template <ContactLaw... Laws>
void check_after_bond(const ContactLawChoice<Laws...>& law, const ContactRange& range,
                      AxiomCheck& check) {
  std::visit([&](const auto& chosen) { check_after_bond(chosen, range, check); }, law.chosen);
}

}  // namespace internal

/// Which axioms of the contact law `law` breaks for contacts within `range`. They are checked for
/// the frictionless law, too, where the loss in sliding hides nothing; a law with a member
/// `may_pull` that is true is allowed tension.
template <ContactLaw Law>
[[nodiscard]] Violations contact_law_violations(const Law& law, const ContactRange& range = {}) {
  AxiomCheck check;
  internal::check_contact_at_rest(law, range, check);
  for (const bool corner : {false, true}) internal::check_collision(law, range, corner, check);
  internal::check_contact_symmetry(law, range, check);
  internal::check_after_bond(law, range, check);
  const Law smooth = frictionless(law);
  internal::check_after_bond(smooth, range, check);
  for (const bool corner : {false, true}) internal::check_collision(smooth, range, corner, check);
  return std::move(check).violations();
}

/// Which results change, beyond their unit, when the same law is written in other units.
/// @param other `law` with its parameters in `units`
template <ContactLaw Law>
[[nodiscard]] Violations contact_law_unit_violations(const Law& law, const Law& other,
                                                     const Units& units = {},
                                                     const ContactRange& range = {}) {
  AxiomCheck check;
  const double large = law.peak_stiffness() * range.deepest;
  check.equal("the peak stiffness is the same in other units",
              other.peak_stiffness() / units.stiffness(), law.peak_stiffness(),
              1e-12 * law.peak_stiffness());
  typename Law::History history{}, of_other{};
  internal::visit_collision(
      range, true, internal::collision_time(law, range), [&](internal::CollisionInstant now) {
        const ContactForce force = law(now.geometry, now.motion, history);
        const double stored = law.stored_energy(now.geometry, history);
        now.geometry.point *= units.length;
        now.geometry.depth *= units.length;
        now.geometry.area *= units.area();
        now.geometry.chord *= units.length;
        now.motion.normal_velocity *= units.velocity();
        now.motion.tangential_velocity *= units.velocity();
        now.motion.time_step *= units.time;
        now.motion.effective_mass *= units.mass;
        const ContactForce same = other(now.geometry, now.motion, of_other);
        check.equal("the normal force is the same in other units", same.normal / units.force(),
                    force.normal, 1e-10 * large);
        check.equal("the tangential force is the same in other units",
                    same.tangential / units.force(), force.tangential, 1e-10 * large);
        check.equal("stored energy is the same in other units",
                    other.stored_energy(now.geometry, of_other) / units.energy(), stored,
                    1e-10 * large * range.deepest);
      });
  return std::move(check).violations();
}

}  // namespace riprap
