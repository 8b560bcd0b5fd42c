// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the contact law: from the geometry and motion of a contact to its force.

#include <concepts>

#include <riprap/contact/pair/contact_geometry.hpp>
#include <riprap/core/policy.hpp>

namespace riprap {

/// How the two bodies move at a contact during the step that led to its present geometry.
struct ContactMotion {
  double normal_velocity = 0;      ///< of b relative to a along the normal [m/s]; closing: negative
  double tangential_velocity = 0;  ///< of b relative to a along the tangent [m/s]
  double time_step = 0;            ///< [s]; zero: re-evaluate without motion
  double effective_mass = 0;       ///< m_a m_b / (m_a + m_b) [kg], of driven bodies infinite mass
};

/// The force that a exerts on b.
struct ContactForce {
  double normal = 0;         ///< along the normal [N], pushing: positive
  double tangential = 0;     ///< along the tangent [N]
  double friction_loss = 0;  ///< energy lost in sliding during the step [J], >= 0
  double viscous_loss = 0;   ///< energy lost in dashpots during the step [J], >= 0
};

namespace requirements {

/// `L::History`: what a contact carries from step to step. Every new contact starts with
/// `History{}`, and contacts are moved when they are sorted.
template <class L>
concept ContactLawHistory =
    requires { typename L::History; } && std::semiregular<typename L::History>;

/// `law(geometry, motion, history)` -> ContactForce; updates the history. Evaluated again with
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

/// `law.peak_stiffness()` [N/m]: largest slope of force against depth; sets the time step.
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

}  // namespace requirements

/// A `ContactLaw` computes contact forces.
///
/// Optional: a member `friction` [-], or `law.frictionless()` that returns another law of its type:
/// experiments take the friction away while they compact, if the law can be assigned. A member
/// `may_pull` that is true: the normal force may be negative.
template <class L>
concept ContactLaw =
    Policy<L> && requirements::ContactLawHistory<L> && requirements::ContactLawCall<L> &&
    requirements::ContactLawEnergy<L> && requirements::ContactLawStiffness<L> &&
    requirements::ContactLawFrictionless<L>;

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
  }
  return ContactLaw<L>;
}

}  // namespace riprap
