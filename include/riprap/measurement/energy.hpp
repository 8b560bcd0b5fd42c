// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Kinetic energy of the bodies, and energy stored in contacts and bonds.

#include <array>

#include <riprap/core/exact_sum.hpp>
#include <riprap/measurement/contact_sum.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Of the free bodies [J], with the masses that enter the equations of motion.
[[nodiscard]] inline double kinetic_energy(const Particles& particles) {
  ExactSum sum;
  for (const Body& body : particles.bodies())
    if (body.is_free()) sum.add(body.kinetic_energy());
  return sum.value();
}

/// What the contacts can give back [J].
template <class Contacts>
[[nodiscard]] double stored_energy(const Contacts& contacts) {
  return sum_over_contacts<1>(contacts, [&](const auto& c) {
    return std::array{contacts.law().stored_energy(c.geometry, c.history)};
  })[0];
}

/// Whether the model of a simulation has a bond law.
template <class Sim>
inline constexpr bool has_bonds = requires { requires Sim::bonded; };

/// What contacts and bonds can give back [J].
template <class Sim>
[[nodiscard]] double stored_energy_of(const Sim& sim) {
  double energy = stored_energy(sim.contacts());
  if constexpr (has_bonds<Sim>) energy += sim.bonds().stored_energy(sim.particles().thickness());
  return energy;
}

/// Energy lost in bonds since the start, by damage and when they broke [J].
template <class Sim>
[[nodiscard]] double bond_loss(const Sim& sim) {
  if constexpr (has_bonds<Sim>)
    return sim.bonds().loss();
  else
    return 0;
}

}  // namespace riprap
