// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Contacts of the pieces of particles that have broken, evaluated without those of others.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <riprap/contact/contact_forces.hpp>
#include <riprap/contact/detection/find_contact.hpp>
#include <riprap/contact/divided_contacts.hpp>
#include <riprap/contact/pair/pair_table.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Recorded break by break, with the contacts of the parents; evaluated when all have broken.
template <class ContactType>
class PieceContacts {
 public:
  /// The particle at `parent` is about to be divided or cut off; `forget(k)` is called for the
  /// index of each of its pairs.
  template <class Forget>
  void record(const PairTable<ContactType>& table, BodyIndex parent, Forget&& forget) {
    add(parent);
    if (parent >= table.index().size()) return;  // a piece that has no pairs yet
    for (const PairSide side : table.index().of(parent)) {
      forget(side.pair());
      const ContactType& pair = table.pairs()[side.pair()];
      if (!pair.touching) continue;
      histories.add(pair);
      bodies_.insert(bodies_.end(), {pair.a, pair.b});
    }
  }
  void add(BodyIndex piece) { pieces_.push_back(piece); }
  [[nodiscard]] std::span<const BodyIndex> pieces() const { return pieces_; }

  /// Finds the contacts of all pieces recorded and their forces, at the present poses and without
  /// motion, and sums the forces on every body of such a contact anew: what an update of all
  /// contacts would find, but for velocities that have changed since.
  /// @param losses of the tasks; what the contacts lose is added
  template <class Narrow, class Law, class Domain>
  void update(PairTable<ContactType>& table, Particles& particles, const Narrow& narrow,
              const Law& law, const Domain& domain, std::span<ContactLosses> losses) {
    pairs_.clear();
    for (const BodyIndex piece : pieces_)
      for (const PairSide side : table.index().of(piece)) pairs_.push_back(side.pair());
    sort_unique(pairs_);
    bodies_.insert(bodies_.end(), pieces_.begin(), pieces_.end());
    for (const std::uint32_t k : pairs_) {
      ContactType& contact = table.pairs()[k];
      const bool touched = contact.touching;
      contact.cache = decltype(contact.cache){};  // of the parent's shape
      const bool touches = find_contact(contact, particles, narrow, domain);
      if (touched != touches) table.list_touching(k);
      if (touches) bodies_.insert(bodies_.end(), {contact.a, contact.b});
    }
    histories.hand_over(law, [&](const ContactType& of) { return table.list().find_touching(of); });
    for (const std::uint32_t k : pairs_) {
      ContactType& contact = table.pairs()[k];
      if (!contact.touching) continue;
      losses[task_of(contact.a)].add(find_force(contact, particles, law, domain, 0));
    }
    sort_unique(bodies_);
    for (const BodyIndex i : bodies_)
      particles.body(i).contact =
          sum_forces(table.index().of(i), std::span<const ContactType>(table.pairs()));
    pieces_.clear();
    bodies_.clear();
  }

  DividedContacts<ContactType> histories;

 private:
  template <class T>
  static void sort_unique(std::vector<T>& list) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }

  std::vector<BodyIndex> pieces_;
  std::vector<BodyIndex> bodies_;     // that touch a parent or a piece
  std::vector<std::uint32_t> pairs_;  // workspace of `update`
};

}  // namespace riprap
