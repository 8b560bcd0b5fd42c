// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// How many neighbours a particle touches.

#include <cstddef>
#include <vector>

#include <riprap/particle/particles.hpp>

namespace riprap {

/// Contacts of the N free particles. M counts a contact between two of them once and one with a
/// driven particle half, so that the boundary does not dilute the mean.
struct Coordination {
  double contacts_per_particle = 0;  ///< M / N: gamma of eq. 8
  double coordination_number = 0;    ///< 2 M / N: the mean number of contacts of a free particle

  static void for_each_field(auto& self, auto&& visit) {
    visit("contacts_per_particle", self.contacts_per_particle);
    visit("coordination_number", self.coordination_number);
  }
};

/// Contacts of every body, in the order of the bodies.
template <class Contacts>
[[nodiscard]] std::vector<unsigned> contact_counts(const Contacts& contacts,
                                                   const Particles& particles) {
  std::vector<unsigned> counts(particles.size(), 0);
  contacts.for_each_touching([&](const auto& c) {
    ++counts[c.a];
    ++counts[c.b];
  });
  return counts;
}

template <class Contacts>
[[nodiscard]] Coordination coordination(const Contacts& contacts, const Particles& particles) {
  std::size_t ends = 0;
  std::size_t free = 0;
  for (const Body& body : particles.bodies()) free += body.is_free();
  contacts.for_each_touching([&](const auto& c) {
    ends += particles.body(c.a).is_free();
    ends += particles.body(c.b).is_free();
  });
  if (free == 0) return {};
  const double mean = static_cast<double>(ends) / static_cast<double>(free);
  return {0.5 * mean, mean};
}

}  // namespace riprap
