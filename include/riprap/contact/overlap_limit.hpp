// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Refuses overlaps so large that one particle has penetrated another.

#include <riprap/contact/concepts.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Largest overlap of a contact, as a fraction of the area of the smaller particle. Beyond it one
/// particle has penetrated the other, or they overlapped from the start.
inline constexpr double most_overlap = 0.75;

/// Throws SimulationError, naming the particles, for a contact with a larger overlap.
template <TouchingContacts C>
[[gnu::cold]] void refuse_deep_overlaps(const C& contacts, const Particles& particles) {
  contacts.for_each_touching([&](const auto& contact) {
    const bool first = particles.shape(contact.a).area < particles.shape(contact.b).area;
    const BodyIndex smaller = first ? contact.a : contact.b;
    const double share = contact.geometry.area / particles.shape(smaller).area;
    if (share <= most_overlap) return;
    throw SimulationError(particle_text(particles.ancestry(contact.a).id) + " and " +
                          particle_text(particles.ancestry(contact.b).id) + " overlap in " +
                          to_text(share) + " of the area of the smaller one: at most " +
                          to_text(most_overlap) + " makes a contact");
  });
}

}  // namespace riprap
