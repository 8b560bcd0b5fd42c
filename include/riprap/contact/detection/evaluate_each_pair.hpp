// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Every pair is evaluated on its own at every step: the detection without acceleration.

#include <riprap/contact/detection/concepts.hpp>
#include <riprap/contact/detection/find_contact.hpp>

namespace riprap {

/// Nothing is kept from step to step: the narrow phase starts with an empty cache.
struct EvaluateEachPair {
  template <class Narrow>
  struct State {
    void carry(const PairMap&) {}
    void forget(std::size_t) {}
    void forget_all() {}

    template <class Input>
    void find(const Input& input, ContactTask& task) const {
      task.touching.clear();
      task.crossing.clear();
      task.for_each_pair([&](std::size_t k) {
        auto& contact = input.pairs[k];
        contact.cache = typename Narrow::Cache{};
        if (!find_contact(contact, input.particles, input.narrow, input.domain)) return;
        task.touching.push_back(static_cast<std::uint32_t>(k));
        if (contact.crosses_boundary) task.crossing.push_back(static_cast<std::uint32_t>(k));
      });
    }
  };
};

static_assert(Detection<EvaluateEachPair>);

}  // namespace riprap
