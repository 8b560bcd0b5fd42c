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

/// A narrow phase with batches: pairs that touched are collected, each kind by itself, until a
/// batch is full.
template <NarrowPhase Narrow>
  requires BatchedNarrowPhase<Narrow>
class PairBatch<Narrow> {
 public:
  /// Adds pair k; false if it has to be evaluated singly. Images have no ring in memory.
  template <class ContactType>
  [[nodiscard]] bool add(std::size_t k, ContactType& contact, const Particles& particles) {
    if (contact.crosses_boundary || !contact.touching) return false;
    std::size_t kind = 0;
    if constexpr (kinds > 1) kind = Narrow::Batch::kind(contact.cache);
    if (kind >= kinds) return false;
    last_ = &batches_[kind];
    last_->indices[last_->pairs.size()] = k;
    return last_->pairs.add(particles.ring(contact.a), particles.ring(contact.b), contact.cache,
                            contact.geometry);
  }
  /// Evaluates the batch that a pair has been added to if it is full, and calls `single(k)` for its
  /// pairs that have to be evaluated singly.
  template <class Single>
  void find_if_full(const Narrow& narrow, Single&& single) {
    Batch& batch = *last_;
    if (batch.pairs.size() < batch.indices.size()) return;
    const unsigned found = narrow.find(batch.pairs);
    for (std::size_t l = 0; l < batch.indices.size(); ++l)
      if ((found >> l & 1U) == 0) single(batch.indices[l]);
    batch.pairs.clear();
  }
  /// Calls `single(k)` for the pairs of incomplete batches.
  template <class Single>
  void finish(Single&& single) {
    for (Batch& batch : batches_) {
      for (std::size_t l = 0; l < batch.pairs.size(); ++l) single(batch.indices[l]);
      batch.pairs.clear();
    }
  }

 private:
  struct Batch {
    typename Narrow::Batch pairs;
    std::array<std::size_t, Narrow::Batch::capacity> indices;
  };
  static constexpr std::size_t kinds = [] {
    if constexpr (requires { Narrow::Batch::kinds; })
      return Narrow::Batch::kinds;
    else
      return std::size_t{1};
  }();

  std::array<Batch, kinds> batches_;
  Batch* last_ = nullptr;
};

}  // namespace riprap
