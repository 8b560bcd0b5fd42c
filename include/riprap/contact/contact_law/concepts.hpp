// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the contact law: from the geometry and motion of a contact to its force.

#include <concepts>

#include <riprap/contact/pair/contact_geometry.hpp>
#include <riprap/core/ids.hpp>
#include <riprap/core/policy.hpp>

namespace riprap {

/// How the two bodies move at a contact during the step that led to its present geometry.
struct ContactMotion {
  double normal_velocity = 0;      ///< of b relative to a along the normal [m/s]; closing: negative
  double tangential_velocity = 0;  ///< of b relative to a along the tangent [m/s]
  double time_step = 0;            ///< [s]; zero: re-evaluate without motion
  double effective_mass = 0;       ///< m_a m_b / (m_a + m_b) [kg], of driven bodies infinite mass
  MaterialIndex material_a = 0;    ///< of the two bodies, in the simulation's list of rocks
  MaterialIndex material_b = 0;
};

/// The force that a exerts on b.
struct ContactForce {
  double normal = 0;         ///< along the normal [N], pushing: positive
  double tangential = 0;     ///< along the tangent [N]
  double friction_loss = 0;  ///< energy lost in sliding during the step [J], >= 0
  double viscous_loss = 0;   ///< energy lost in dashpots during the step [J], >= 0
};

/// A contact of a piece of a particle that has just broken.
struct DividedContact {
  const ContactGeometry& geometry;
  double share = 1;       ///< of its overlap in that of the old contact [-]
  bool has_point = true;  ///< the piece on whose side the contact of the particle acted
};

/// What a bond leaves to the contact that takes its place.
struct FormerBond {
  double normal_force = 0;       ///< with which its edges pushed each other [N], >= 0
  double normal_energy = 0;      ///< stored in that [J]
  double tangential_force = 0;   ///< on b along the tangent [N]
  double tangential_energy = 0;  ///< stored in that [J]
  MaterialIndex material_a = 0;  ///< of the two bodies, in the simulation's list of rocks
  MaterialIndex material_b = 0;
};

namespace requirements {

/// `L::History`: what a contact carries from step to step. Every new contact starts with
/// `History{}`, and contacts are moved when they are sorted.
template <class L>
concept ContactLawHistory =
    requires { typename L::History; } && std::semiregular<typename L::History>;

/// `law(geometry, motion, history)` -> ContactForce; updates the history. The normal force of an
/// energy U(depth) is U'(depth) times `geometry.depth_gradient`. Evaluated again with
/// `time_step == 0` it must give the same force and lose nothing. Const: what is remembered belongs
/// to the contact.
template <class L>
concept ContactLawCall = requires(const L& law, const ContactGeometry& geometry,
                                  const ContactMotion& motion, typename L::History& history) {
  { law(geometry, motion, history) } -> std::convertible_to<ContactForce>;
};

/// `law.stored_energy(geometry, history)` [J]: what the contact can give back. Without it no energy
/// balance could be drawn up.
template <class L>
concept ContactLawEnergy =
    requires(const L& law, const ContactGeometry& geometry, const typename L::History& history) {
      { law.stored_energy(geometry, history) } -> std::convertible_to<double>;
    };

/// `law.peak_stiffness()` [N/m]: largest slope of force against displacement where the gradient of
/// the depth is one; sets the time step.
template <class L>
concept ContactLawStiffness = requires(const L& law) {
  { law.peak_stiffness() } -> std::convertible_to<double>;
};

/// Optional: `law.frictionless()` -> another law of its type. A non-const function would be ignored
/// silently, and samples would be compacted with friction.
template <class L>
concept ContactLawFrictionless =
    !requires(L& law) { law.frictionless(); } || requires(const L& law) {
      { law.frictionless() } -> std::convertible_to<L>;
    };

/// Optional: `law.with_friction(mu)` -> another law of its type with that friction coefficient [-].
/// A non-const function would be ignored silently.
template <class L>
concept ContactLawWithFriction =
    !requires(L& law) { law.with_friction(0.0); } || requires(const L& law) {
      { law.with_friction(0.0) } -> std::convertible_to<L>;
    };

/// Optional: `law.divided_history(history, geometry, part)` -> the history with which the contact
/// `part` of a piece begins, from those of the contact before the break. Its stored energy should
/// be at most `part.share` of what it was. Without it the piece with the contact's point gets the
/// history, and other contacts of pieces are new.
template <class L>
concept ContactLawDivided =
    !requires(L& law, const ContactGeometry& geometry, const typename L::History& history,
              const DividedContact& part) { law.divided_history(history, geometry, part); } ||
    requires(const L& law, const ContactGeometry& geometry, const typename L::History& history,
             const DividedContact& part) {
      { law.divided_history(history, geometry, part) } -> std::convertible_to<typename L::History>;
    };

/// Optional: `law.history_after_bond(geometry, bond)` -> the history with which a contact begins
/// where a bond has broken: bodies whose bond was compressed overlap at once. Its force and energy
/// should be at most those of the bond. Without it the contact is new.
template <class L>
concept ContactLawAfterBond =
    !requires(L& law, const ContactGeometry& geometry, const FormerBond& bond) {
      law.history_after_bond(geometry, bond);
    } || requires(const L& law, const ContactGeometry& geometry, const FormerBond& bond) {
      { law.history_after_bond(geometry, bond) } -> std::convertible_to<typename L::History>;
    };

}  // namespace requirements

/// A `ContactLaw` computes contact forces.
///
/// Optional: a member `friction` [-], or `law.frictionless()` that returns another law of its type:
/// experiments take the friction away while they compact, if the law can be assigned; likewise
/// `law.with_friction(mu)` for samples that are compacted with another friction. A member
/// `may_pull` that is true: the normal force may be negative. `law.divided_history` for contacts of
/// particles that break, `law.history_after_bond` for those where a bond has broken.
/// `law.materials()`: for how many materials it has parameters; none or 0: the same for all.
template <class L>
concept ContactLaw =
    Policy<L> && requirements::ContactLawHistory<L> && requirements::ContactLawCall<L> &&
    requirements::ContactLawEnergy<L> && requirements::ContactLawStiffness<L> &&
    requirements::ContactLawFrictionless<L> && requirements::ContactLawWithFriction<L> &&
    requirements::ContactLawDivided<L> && requirements::ContactLawAfterBond<L>;

template <class L>
consteval bool check_contact_law() {
  check_policy<L>();
  static_assert(
      requirements::ContactLawHistory<L>,
      "riprap: a ContactLaw must have a type History that can be default-constructed and copied");
  if constexpr (requirements::ContactLawHistory<L>) {  // the others cannot be checked without it
    static_assert(requirements::ContactLawCall<L>,
                  "riprap: a ContactLaw must have ContactForce operator()(const ContactGeometry&, "
                  "const ContactMotion&, History&) const");
    static_assert(
        requirements::ContactLawEnergy<L>,
        "riprap: a ContactLaw must have double stored_energy(const ContactGeometry&, const "
        "History&) const");
    static_assert(requirements::ContactLawStiffness<L>,
                  "riprap: a ContactLaw must have double peak_stiffness() const");
    static_assert(requirements::ContactLawFrictionless<L>,
                  "riprap: frictionless() of a ContactLaw must be const and return such a law");
    static_assert(
        requirements::ContactLawWithFriction<L>,
        "riprap: with_friction(double) of a ContactLaw must be const and return such a law");
    static_assert(requirements::ContactLawDivided<L>,
                  "riprap: divided_history of a ContactLaw must be History divided_history(const "
                  "History&, const ContactGeometry&, const DividedContact&) const");
    static_assert(requirements::ContactLawAfterBond<L>,
                  "riprap: history_after_bond of a ContactLaw must be History "
                  "history_after_bond(const ContactGeometry&, const FormerBond&) const");
  }
  return ContactLaw<L>;
}

/// The history of the contact of a piece, from that of the contact before the break.
template <ContactLaw L>
[[nodiscard]] typename L::History divided_history(const L& law, const typename L::History& history,
                                                  const ContactGeometry& geometry,
                                                  const DividedContact& part) {
  if constexpr (requires { law.divided_history(history, geometry, part); })
    return law.divided_history(history, geometry, part);
  else
    return part.has_point ? history : typename L::History{};
}

/// The history with which a contact begins where a bond has broken.
template <ContactLaw L>
[[nodiscard]] typename L::History history_after_bond(const L& law, const ContactGeometry& geometry,
                                                     const FormerBond& bond) {
  if constexpr (requires { law.history_after_bond(geometry, bond); })
    return law.history_after_bond(geometry, bond);
  else
    return typename L::History{};
}

}  // namespace riprap
