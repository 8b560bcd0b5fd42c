// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// One influence operator for each particle, kept until it breaks: the store without acceleration.

#include <memory>
#include <utility>
#include <vector>

#include <riprap/stress/operator_store/concepts.hpp>

namespace riprap {

/// Memory is not limited: 140 to 190 kB for each particle of 100 triangles.
struct KeepAllOperators {
  class State {
   public:
    explicit State(const KeepAllOperators& = {}) {}

    template <class Build>
    const InfluenceOperator& exact(BodyIndex i, Build&& build) {
      if (operators_.size() <= i) operators_.resize(i + 1);
      if (!operators_[i]) operators_[i] = build();
      return *operators_[i];
    }
    [[nodiscard]] const InfluenceOperator* find(BodyIndex i) const {
      return i < operators_.size() ? operators_[i].get() : nullptr;
    }
    void forget(BodyIndex i) {
      if (i < operators_.size()) operators_[i].reset();
    }
    void begin_epoch(std::size_t) {}
    [[nodiscard]] std::size_t bytes() const {
      std::size_t sum = 0;
      for (const auto& op : operators_)
        if (op) sum += op->bytes();
      return sum;
    }

   private:
    std::vector<std::unique_ptr<InfluenceOperator>> operators_;
  };
};

static_assert(OperatorStore<KeepAllOperators>);

}  // namespace riprap
