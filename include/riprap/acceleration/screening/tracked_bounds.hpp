// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Incremental bounds of all particles: their weights, stored by the sides of pairs.

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <riprap/acceleration/screening/incremental_bound.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/stress/contact_loads.hpp>

namespace riprap {

/// For each particle whose bound is tracked, the number of its contacts and their weights.
class TrackedBounds {
 public:
  /// Follows a new list of pairs. Weights move with their pairs: they refer to one particle of a
  /// pair, whatever the other is; a particle that lost a pair is found by its number of contacts.
  template <ListedContacts Contacts>
  void begin(const Contacts& contacts, std::size_t particles) {
    const PairMap& map = contacts.map();
    if (revision_ != map.to()) {
      if (map.leads_from(revision_)) {
        map.carry(sensitivities_, workspace_, LoadSensitivity{}, 2);
      } else {
        sensitivities_.assign(2 * contacts.pairs().size(), {});
        std::fill(contact_counts_.begin(), contact_counts_.end(), IncrementalBound::untracked);
      }
      revision_ = map.to();
    }
    contact_counts_.resize(particles, IncrementalBound::untracked);
  }

  /// Accumulates the bounds of particles `first` to `last`, those of a task, in the order of their
  /// contacts in memory, and calls `candidate(i)` for each whose bound does not exclude that it
  /// breaks now.
  template <ListedContacts Contacts, class Candidate>
  void check(const Particles& particles, const Contacts& contacts, std::size_t task,
             std::size_t first, std::size_t last, Candidate&& candidate) const {
    std::array<IncrementalBound, task_size> bounds;
    for (std::size_t i = first; i < last; ++i)
      bounds[i - first] =
          IncrementalBound(particles.body(static_cast<BodyIndex>(i)).rotation, contact_counts_[i]);
    // One of the two bodies is the task's, and a < b.
    const LoadSensitivity* const sensitivities = sensitivities_.data();
    contacts.for_each_touching_of(task, [&](const auto& c, std::size_t k) {
      const Vec2 on_b = c.force_on_b();
      if (c.a >= first) bounds[c.a - first].accumulate(sensitivities[2 * k], c.arm_a, on_b);
      if (c.b < last) bounds[c.b - first].accumulate(sensitivities[2 * k + 1], c.arm_b, on_b);
    });
    for (std::size_t i = first; i < last; ++i)
      if (!bounds[i - first].within_budget()) candidate(static_cast<BodyIndex>(i));
  }

  /// Starts the bound of particle i with a weight for each of its loads; NaN for its pairs that do
  /// not touch.
  void track(BodyIndex i, std::span<const ContactLoad> loads, std::span<const PairSide> sides,
             std::span<const LoadSensitivity> sensitivities) {
    for (const PairSide side : sides) sensitivities_[side.index()] = {};
    for (std::size_t c = 0; c < loads.size(); ++c)  // on side a, for the force on b
      sensitivities_[loads[c].side.index()] =
          loads[c].side.is_b() ? sensitivities[c] : sensitivities[c].opposite();
    contact_counts_[i] = static_cast<std::uint32_t>(loads.size());
  }
  void untrack(BodyIndex i) {
    if (i < contact_counts_.size()) contact_counts_[i] = IncrementalBound::untracked;
  }

 private:
  std::uint64_t revision_ = 0;
  std::vector<LoadSensitivity> sensitivities_;  // of each side of the pairs
  std::vector<LoadSensitivity> workspace_;
  std::vector<std::uint32_t> contact_counts_;  // of each particle
};

}  // namespace riprap
