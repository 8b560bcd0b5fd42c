// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Contacts that take the place of bonds.

#include <riprap/contact/contact_law/concepts.hpp>
#include <riprap/contact/detection/find_contact.hpp>
#include <riprap/core/ids.hpp>

namespace riprap {

/// Two bodies whose last bond has broken.
template <class Image>
struct FormerPair {
  BodyIndex a = 0;
  BodyIndex b = 0;
  [[no_unique_address]] Image image{};
  FormerBond bond{};
};

/// The contact of a pair whose bond has broken, at the present poses: it begins with what the bond
/// leaves, if the law says so.
/// @param bond without its materials, which are those of the bodies
/// @return energy that the contact stores [J]
template <class ContactType, class Narrow, class Law, class Domain>
double begin_contact(ContactType& contact, const FormerBond& bond, const Particles& particles,
                     const Narrow& narrow, const Law& law, const Domain& domain) {
  contact.touching = false;
  contact.cache = decltype(contact.cache){};
  if (!find_contact(contact, particles, narrow, domain)) return 0;
  FormerBond left = bond;
  left.material_a = particles.material(contact.a);
  left.material_b = particles.material(contact.b);
  contact.history = history_after_bond(law, contact.geometry, left);
  return law.stored_energy(contact.geometry, contact.history);
}

}  // namespace riprap
