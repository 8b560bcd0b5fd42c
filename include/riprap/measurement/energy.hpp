// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Kinetic energy of the bodies and energy stored in the contacts.

#include <riprap/particle/particles.hpp>

namespace riprap {

/// Of the free bodies [J], with the masses that enter the equations of motion.
[[nodiscard]] inline double kinetic_energy(const Particles& particles) {
  double sum = 0;
  for (const Body& body : particles.bodies())
    if (body.is_free()) sum += body.kinetic_energy();
  return sum;
}

/// What the contacts can give back [J].
template <class Contacts>
[[nodiscard]] double stored_energy(const Contacts& contacts) {
  double sum = 0;
  contacts.for_each_touching(
      [&](const auto& c) { sum += contacts.law().stored_energy(c.geometry, c.history); });
  return sum;
}

}  // namespace riprap
