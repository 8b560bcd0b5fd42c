#pragma once
/// @file
/// The role of the contact law: from the geometry and motion of a contact to its force.

#include <concepts>

#include <riprap/contact/contact_geometry.hpp>

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
  double normal = 0;      ///< along the normal [N], pushing: positive
  double tangential = 0;  ///< along the tangent [N]
  double slipped = 0;     ///< energy lost in sliding during the step [J], >= 0
  double damped = 0;      ///< energy lost in dashpots during the step [J], >= 0
};

/// A `ContactLaw` computes contact forces.
///
/// - `L::History`: what a contact carries from step to step; a new contact starts with `History{}`.
/// - `law(geometry, motion, history)` -> ContactForce; updates the history. Evaluated again with
///   `time_step == 0` it must give the same force and lose nothing.
/// - `law.stored_energy(geometry, history)` [J]: what the contact can give back.
/// - `law.peak_stiffness()` [N/m]: largest slope of force against depth; sets the time step.
/// - `law.validate()`: throws InvalidInput for parameters that break a rule.
///
/// A law that has a member `friction` lets experiments switch friction off while they compact. One
/// whose normal force may be negative says so with a member `may_pull` that is true.
template <class L>
concept ContactLaw = std::default_initializable<typename L::History> &&
                     requires(const L& law, const ContactGeometry& geometry,
                              const ContactMotion& motion, typename L::History& history) {
                       { law(geometry, motion, history) } -> std::same_as<ContactForce>;
                       { law.stored_energy(geometry, history) } -> std::convertible_to<double>;
                       { law.peak_stiffness() } -> std::convertible_to<double>;
                       law.validate();
                     };

}  // namespace riprap
