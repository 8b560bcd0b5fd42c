// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Particles that carry no load, and the coordination number without them.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <riprap/core/linkage.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// The two bodies of a contact that transmits a force.
using LoadedContact = std::array<BodyIndex, 2>;

/// Contacts with a force; those that touch without any carry no load.
template <class Contacts>
[[nodiscard]] std::vector<LoadedContact> loaded_contacts(const Contacts& contacts) {
  std::vector<LoadedContact> out;
  contacts.for_each_touching([&](const auto& c) {
    if (c.force.normal != 0 || c.force.tangential != 0) out.push_back({c.a, c.b});
  });
  return out;
}

/// Which bodies are rattlers: free ones with fewer than `fewest` loaded contacts, not counting
/// those with other rattlers, found by removing such bodies until none is left (the rest is a
/// `fewest`-core, which does not depend on the order of removal). Driven bodies never are.
///
/// With friction and without body forces equilibrium takes two contacts: two forces along one line.
/// Without friction or moments at the contacts it takes three in general. Under gravity a particle
/// that lies on one other counts as a rattler: it carries nothing but itself.
/// @param is_free of every body
[[nodiscard]] std::vector<bool> rattlers(std::span<const LoadedContact> contacts,
                                         const std::vector<bool>& is_free, unsigned fewest = 2);

/// Of every body of a state, in the order of the bodies.
template <class Contacts>
[[nodiscard]] std::vector<bool> rattlers(const Contacts& contacts, const Particles& particles,
                                         unsigned fewest = 2) {
  std::vector<bool> is_free;
  for (const Body& body : particles.bodies()) is_free.push_back(body.is_free());
  return rattlers(loaded_contacts(contacts), is_free, fewest);
}

/// Loaded contacts of free particles; one with a driven body counts once, at the free one.
struct MechanicalCoordination {
  double loaded = 0;  ///< Z: loaded contacts of a free particle, mean over all
  /// Z_m = (2 N_c - N_1) / (N_p - N_0 - N_1) of Thornton (2000), where N_0 and N_1 particles have
  /// no and one loaded contact: their own ends of contacts are left out, once.
  double mechanical = 0;
  double rattler_free = 0;    ///< mean over particles that are no rattlers, of contacts among these
  std::size_t particles = 0;  ///< free ones
  std::size_t rattlers = 0;

  [[nodiscard]] double rattler_share() const {
    return particles == 0 ? 0 : static_cast<double>(rattlers) / static_cast<double>(particles);
  }
};

[[nodiscard]] MechanicalCoordination
mechanical_coordination(std::span<const LoadedContact> contacts, const std::vector<bool>& is_free,
                        unsigned fewest = 2);

template <class Contacts>
[[nodiscard]] MechanicalCoordination
mechanical_coordination(const Contacts& contacts, const Particles& particles, unsigned fewest = 2) {
  std::vector<bool> is_free;
  for (const Body& body : particles.bodies()) is_free.push_back(body.is_free());
  return mechanical_coordination(loaded_contacts(contacts), is_free, fewest);
}

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/measurement/rattlers.ipp>
#endif
