// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Contact detection of one pair.

#include <array>
#include <optional>

#include <riprap/contact/pair/contact_geometry.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/particle/domain.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Narrow phase of the bodies a and b of a pair, or of a and the image of b.
template <class ContactType, class Narrow, class Domain>
[[nodiscard]] std::optional<ContactGeometry>
evaluate_narrow_phase(ContactType& contact, const Particles& particles, const Narrow& narrow,
                      const Domain& domain) {
  const Ring ring = particles.ring(contact.b);
  if constexpr (Domain::periodic) {
    if (contact.crosses_boundary) {
      const Vec2 offset = domain.offset(contact.image);
      std::array<Vec2, max_polygon_vertices> image;
      for (std::size_t k = 0; k < ring.size(); ++k) image[k] = ring[k] + offset;
      return narrow(particles.ring(contact.a), Ring{image.data(), ring.size()}, contact.cache);
    }
  }
  return narrow(particles.ring(contact.a), ring, contact.cache);
}

/// Finds whether and how a pair touches; a contact that begins starts without history.
template <class ContactType, class Narrow, class Domain>
[[gnu::always_inline]] inline bool find_contact(ContactType& contact, const Particles& particles,
                                                const Narrow& narrow, const Domain& domain) {
  const std::optional<ContactGeometry> geometry =
      evaluate_narrow_phase(contact, particles, narrow, domain);
  if (geometry) {
    using History = decltype(contact.history);
    if (!contact.touching) contact.history = History{};
    contact.geometry = *geometry;
  }
  contact.touching = geometry.has_value();
  return contact.touching;
}

}  // namespace riprap
