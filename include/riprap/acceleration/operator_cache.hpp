// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Cache of the influence operators of all particles, within a memory budget.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <riprap/acceleration/screening/influence_operator_f32.hpp>
#include <riprap/stress/operator_store/concepts.hpp>

namespace riprap {

/// Operators are built on first use. If the budget does not suffice for all of them, the least
/// recently used ones are evicted and rebuilt on demand, with the same bytes: results do not depend
/// on the budget. With 100 triangles an operator takes 120 to 200 kB in double and 65 to 105 kB in
/// single precision; the more, the blunter the particle. The default.
struct OperatorCache {
  /// 4 GiB: some 45,000 operators of 100 triangles in single precision.
  static constexpr std::size_t default_budget = std::size_t{4} << 30;

  std::size_t budget = default_budget;  ///< [bytes]

  class State;
};

/// The operators of the particles of a simulation.
class OperatorCache::State {
 public:
  explicit State(const OperatorCache& policy = {}) : budget_(policy.budget) {}

  /// Memory budget [bytes]; an operator in use is kept whatever its size.
  void set_budget(std::size_t bytes) { budget_ = bytes; }
  [[nodiscard]] std::size_t budget() const { return budget_; }
  /// Memory in use [bytes].
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

  /// Begins a new epoch: operators used from now on are the most recently used ones.
  void begin_epoch(std::size_t particles) {
    ++epoch_;
    if (slots_.size() < particles) slots_.resize(particles);
  }
  /// Discards the operators of particle i.
  void forget(BodyIndex i) {
    if (i >= slots_.size()) return;
    release(slots_[i].exact);
    release(slots_[i].single_precision);
  }

  /// The operator of particle i, from memory or from `build()`; valid until the next call for
  /// another particle.
  template <class Build>
  const InfluenceOperator& exact(BodyIndex i, Build&& build) {
    if (slots_.size() <= i) slots_.resize(i + 1);
    Entry<InfluenceOperator>& entry = slots_[i].exact;
    entry.epoch = epoch_;
    if (!entry.op) {
      store(entry, build());
      evict_beyond_budget(i);
    }
    return *entry.op;
  }
  /// The operator of particle i, if it is in memory; else null.
  [[nodiscard]] const InfluenceOperator* find(BodyIndex i) const {
    return i < slots_.size() ? slots_[i].exact.op.get() : nullptr;
  }
  /// The operator in single precision; valid until the next `evict`. After `begin_epoch` threads
  /// may call it concurrently, each for other particles.
  template <class Build>
  const InfluenceOperatorF32& single_precision(BodyIndex i, Build&& build) {
    Entry<InfluenceOperatorF32>& entry = slots_[i].single_precision;
    entry.epoch = epoch_;
    if (!entry.op) {
      Entry<InfluenceOperator>& exact = slots_[i].exact;
      std::unique_ptr<InfluenceOperator> made;
      if (!exact.op) made = build();
      store(entry, std::make_unique<InfluenceOperatorF32>(made ? *made : *exact.op));
      if (made && keeps_exact()) {
        exact.epoch = epoch_;
        store(exact, std::move(made));
      }
    }
    return *entry.op;
  }

  /// Evicts operators beyond the budget.
  void evict() { evict_beyond_budget(static_cast<BodyIndex>(slots_.size())); }

 private:
  template <class Op>
  struct Entry {
    std::unique_ptr<Op> op;
    std::uint64_t epoch = 0;  // of the last use
  };
  struct Slot {
    Entry<InfluenceOperator> exact;
    Entry<InfluenceOperatorF32> single_precision;
  };

  template <class Op>
  void store(Entry<Op>& entry, std::unique_ptr<Op> op) {
    entry.op = std::move(op);
    std::atomic_ref(bytes_).fetch_add(entry.op->bytes());
  }
  template <class Op>
  void release(Entry<Op>& entry) {
    if (entry.op) bytes_ -= entry.op->bytes();
    entry.op.reset();
  }

  // Whether operators in double precision are kept after those in single precision were made from
  // them: at 14 MPa every third particle needs its own within 3 % of strain.
  [[nodiscard]] bool keeps_exact() { return std::atomic_ref(bytes_).load() < budget_ / 4; }

  // Down to seven eighths of the budget, so that the search is rare; operators in double precision
  // first, since fewer particles need theirs again. Those of particle `in_use` stay.
  void evict_beyond_budget(BodyIndex in_use) {
    if (bytes_ <= budget_) return;
    const std::size_t goal = budget_ - budget_ / 8;
    evict_least_recent(&Slot::exact, in_use, goal);
    evict_least_recent(&Slot::single_precision, in_use, goal);
  }
  template <class Op>
  void evict_least_recent(Entry<Op> Slot::*kind, BodyIndex in_use, std::size_t goal) {
    if (bytes_ <= goal) return;
    oldest_.clear();
    for (BodyIndex i = 0; i < slots_.size(); ++i)
      if ((slots_[i].*kind).op && i != in_use) oldest_.emplace_back((slots_[i].*kind).epoch, i);
    std::sort(oldest_.begin(), oldest_.end());
    for (const auto& [epoch, i] : oldest_) {
      if (bytes_ <= goal) return;
      release(slots_[i].*kind);
    }
  }

  std::vector<Slot> slots_;
  std::vector<std::pair<std::uint64_t, BodyIndex>> oldest_;
  std::size_t budget_ = default_budget;
  std::size_t bytes_ = 0;
  std::uint64_t epoch_ = 0;
};

static_assert(OperatorStore<OperatorCache>);

}  // namespace riprap
