// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Pairs on their way to a narrow phase that takes several at once.

#include <array>
#include <cstddef>

#include <riprap/contact/narrow_phase/concepts.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Where the narrow phase finds no groups, nobody waits: everybody is asked alone.
template <NarrowPhase Narrow>
class PairGroup {
 public:
  template <class ContactType>
  [[nodiscard]] static bool add(std::size_t, ContactType&, const Particles&) {
    return false;
  }
  template <class Alone>
  static void find_if_full(const Narrow&, Alone&&) {}
  template <class Alone>
  static void finish(Alone&&) {}
};

/// Where it does, pairs that touch wait until they are enough.
template <NarrowPhase Narrow>
  requires FindsGroups<Narrow>
class PairGroup<Narrow> {
 public:
  /// Takes pair number k in; false if it has to be asked alone. Images have no ring in memory.
  template <class ContactType>
  [[nodiscard]] bool add(std::size_t k, ContactType& contact, const Particles& particles) {
    if (contact.across || !contact.touching) return false;
    numbers_[group_.size()] = k;
    return group_.add(particles.ring(contact.a), particles.ring(contact.b), contact.memory,
                      contact.geometry);
  }
  /// Finds the contacts of a full group, and calls `alone(k)` for pairs that have to be asked
  /// alone.
  template <class Alone>
  void find_if_full(const Narrow& narrow, Alone&& alone) {
    if (group_.size() < numbers_.size()) return;
    const unsigned found = narrow.find(group_);
    for (std::size_t l = 0; l < numbers_.size(); ++l)
      if ((found >> l & 1U) == 0) alone(numbers_[l]);
    group_.clear();
  }
  /// Calls `alone(k)` for those that are left.
  template <class Alone>
  void finish(Alone&& alone) {
    for (std::size_t l = 0; l < group_.size(); ++l) alone(numbers_[l]);
    group_.clear();
  }

 private:
  typename Narrow::Group group_;
  std::array<std::size_t, Narrow::Group::capacity> numbers_;
};

}  // namespace riprap
