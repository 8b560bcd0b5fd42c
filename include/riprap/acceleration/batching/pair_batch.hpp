// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Collects pairs for a narrow phase that evaluates several at once (SIMD).

#include <array>
#include <cstddef>

#include <riprap/contact/narrow_phase/concepts.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// A narrow phase without batches: every pair is evaluated singly.
template <NarrowPhase Narrow>
class PairBatch {
 public:
  template <class ContactType>
  [[nodiscard]] static bool add(std::size_t, ContactType&, const Particles&) {
    return false;
  }
  template <class Single>
  static void find_if_full(const Narrow&, Single&&) {}
  template <class Single>
  static void finish(Single&&) {}
};

/// A narrow phase with batches: pairs that touched are collected until a batch is full.
template <NarrowPhase Narrow>
  requires BatchedNarrowPhase<Narrow>
class PairBatch<Narrow> {
 public:
  /// Adds pair k; false if it has to be evaluated singly. Images have no ring in memory.
  template <class ContactType>
  [[nodiscard]] bool add(std::size_t k, ContactType& contact, const Particles& particles) {
    if (contact.crosses_boundary || !contact.touching) return false;
    indices_[batch_.size()] = k;
    return batch_.add(particles.ring(contact.a), particles.ring(contact.b), contact.cache,
                      contact.geometry);
  }
  /// Evaluates a full batch, and calls `single(k)` for its pairs that have to be evaluated singly.
  template <class Single>
  void find_if_full(const Narrow& narrow, Single&& single) {
    if (batch_.size() < indices_.size()) return;
    const unsigned found = narrow.find(batch_);
    for (std::size_t l = 0; l < indices_.size(); ++l)
      if ((found >> l & 1U) == 0) single(indices_[l]);
    batch_.clear();
  }
  /// Calls `single(k)` for the pairs of an incomplete batch.
  template <class Single>
  void finish(Single&& single) {
    for (std::size_t l = 0; l < batch_.size(); ++l) single(indices_[l]);
    batch_.clear();
  }

 private:
  typename Narrow::Batch batch_;
  std::array<std::size_t, Narrow::Batch::capacity> indices_;
};

}  // namespace riprap
