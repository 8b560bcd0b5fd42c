// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Detection that skips separated pairs, evaluates others in batches and prefetches their data.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

#include <riprap/acceleration/batching/pair_batch.hpp>
#include <riprap/acceleration/batching/prefetch.hpp>
#include <riprap/contact/detection/concepts.hpp>
#include <riprap/contact/detection/find_contact.hpp>

namespace riprap {

/// A pair is skipped until its bodies can have approached by the clearance of the last evaluation;
/// pairs that touched are evaluated in batches if the narrow phase has them; caches of the narrow
/// phase are kept. The default.
struct BatchedDetection {
  template <class Narrow>
  class State {
   public:
    void carry(const PairMap& map) { map.carry(skip_until_, workspace_, unknown); }
    void forget(std::size_t k) { skip_until_[k] = unknown; }
    void forget_all() { std::fill(skip_until_.begin(), skip_until_.end(), unknown); }

    template <class Input>
    void find(const Input& input, ContactTask& task) {
      const bool prefetching = input.pairs.size() > pairs_in_cache;
      if (prefetching) prefetch_next_task(task, input.particles);
      const std::size_t active = list_active_pairs(input, task);
      std::uint32_t* const listed = task.touching.data();  // active pairs, then those that touch
      std::size_t last = 0;
      bool all_touch = true;
      PairBatch<Narrow> batch;
      const auto evaluate_single = [&](std::size_t k) { all_touch &= find_single(input, k); };
      task.crossing.clear();
      for (std::size_t place = 0; place < active; ++place) {
        const std::size_t k = listed[place];
        if (prefetching && place + prefetch_distance < active)
          prefetch(&input.pairs[listed[place + prefetch_distance]], sizeof(input.pairs[0]));
        auto& contact = input.pairs[k];
        if (batch.add(k, contact, input.particles)) {
          listed[last++] = static_cast<std::uint32_t>(k);
          batch.find_if_full(input.narrow, evaluate_single);
        } else if (find_single(input, k)) {
          listed[last++] = static_cast<std::uint32_t>(k);
          if (contact.crosses_boundary) task.crossing.push_back(static_cast<std::uint32_t>(k));
        }
      }
      batch.finish(evaluate_single);
      task.touching.resize(last);
      if (!all_touch) remove_separated(input, task);
    }

   private:
    static constexpr double unknown = -std::numeric_limits<double>::infinity();

    // With more pairs the records do not fit into the cache, and access to active pairs is
    // irregular: their records are prefetched, and the rings and bodies of the next task.
    static constexpr std::size_t pairs_in_cache = 20'000;
    static constexpr std::size_t prefetch_distance = 12;
    [[gnu::always_inline]] static void prefetch_next_task(const ContactTask& task,
                                                          const Particles& particles) {
      const std::size_t end = std::min(task.last_body + task_size, particles.size());
      for (std::size_t i = task.last_body; i < end; ++i) {
        const auto body = static_cast<BodyIndex>(i);
        const Ring ring = particles.ring(body);
        prefetch(ring.data(), ring.size_bytes());
        prefetch(&particles.body(body), sizeof(Body));
      }
    }

    // Lists the pairs of a task that may touch, in order, in `task.touching`; returns their number.
    // Branch-free: separation is unpredictable.
    template <class Input>
    [[nodiscard]] std::size_t list_active_pairs(const Input& input, ContactTask& task) const {
      const double displacement = input.list.displacement();
      task.touching.resize(task.pairs());
      std::uint32_t* const active = task.touching.data();
      const double* const skip_until = skip_until_.data();
      std::size_t count = 0;
      task.for_each_pair([&](std::size_t k) {
        active[count] = static_cast<std::uint32_t>(k);
        count += static_cast<std::size_t>(displacement >= skip_until[k]);
      });
      return count;
    }

    // True if pair k touches.
    template <class Input>
    bool find_single(const Input& input, std::size_t k) {
      auto& contact = input.pairs[k];
      if (find_contact(contact, input.particles, input.narrow, input.domain)) {
        skip_until_[k] = unknown;
        return true;
      }
      if constexpr (requires { input.narrow.clearance(contact.cache); })
        skip_until_[k] = input.list.contact_threshold(input.narrow.clearance(contact.cache));
      return false;
    }

    // Batched pairs were optimistically listed as touching; removes those that separated.
    template <class Input>
    static void remove_separated(const Input& input, ContactTask& task) {
      std::erase_if(task.touching, [&](std::uint32_t k) { return !input.pairs[k].touching; });
    }

    std::vector<double> skip_until_;  // of each pair, in terms of the list's displacement()
    std::vector<double> workspace_;
  };
};

static_assert(Detection<BatchedDetection>);

}  // namespace riprap
