// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Kinetic energy of the bodies and energy stored in the contacts.

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

}  // namespace riprap
