// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The influence operators of all particles, within a budget of memory.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include <riprap/material/rock.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/stress/compact_operator.hpp>
#include <riprap/stress/influence_operator.hpp>

namespace riprap {

/// Operators are built when first asked for. Where there is no room for all of them, those that
/// were not asked for longest are dropped and built again on demand, with the same bytes: results
/// do not depend on the budget. Of 100 triangles an exact operator takes 140 to 190 kB, a compact
/// one 80 to 110; the more, the blunter the particle.
template <class StressPart>
class OperatorStore {
 public:
  /// 4 GiB: some 45,000 compact operators of 100 triangles.
  static constexpr std::size_t default_budget = std::size_t{4} << 30;

  OperatorStore(StressPart model, const Rock& rock) : model_(std::move(model)), rock_(rock) {}

  [[nodiscard]] const StressPart& model() const { return model_; }
  /// Memory that operators may take [bytes]; one in use is kept whatever it takes.
  void set_budget(std::size_t bytes) { budget_ = bytes; }
  [[nodiscard]] std::size_t budget() const { return budget_; }
  /// Memory that they take [bytes].
  [[nodiscard]] std::size_t bytes() const { return bytes_; }

  /// Another turn of asking begins: what is asked for from now on was asked for last.
  void begin_turn(std::size_t particles) {
    ++turn_;
    if (slots_.size() < particles) slots_.resize(particles);
  }
  /// Another particle lives at i now.
  void forget(BodyIndex i) {
    if (i >= slots_.size()) return;
    drop(slots_[i].exact);
    drop(slots_[i].compact);
  }

  /// The operator of particle i; good until the next call for another particle.
  const InfluenceOperator& exact(const Particles& particles, BodyIndex i) {
    if (slots_.size() < particles.size()) slots_.resize(particles.size());
    Held<InfluenceOperator>& held = slots_[i].exact;
    held.turn = turn_;
    if (!held.op) {
      keep(held, build(particles, i));
      make_room(i);
    }
    return *held.op;
  }
  /// Its compact form; good until the next `trim`. After `begin_turn` threads may ask at once, each
  /// for other particles.
  const CompactOperator& compact(const Particles& particles, BodyIndex i) {
    Held<CompactOperator>& held = slots_[i].compact;
    held.turn = turn_;
    if (!held.op) {
      Held<InfluenceOperator>& exact = slots_[i].exact;
      std::unique_ptr<InfluenceOperator> made;
      if (!exact.op) made = build(particles, i);
      keep(held, std::make_unique<CompactOperator>(made ? *made : *exact.op));
      if (made && has_plenty()) {
        exact.turn = turn_;
        keep(exact, std::move(made));
      }
    }
    return *held.op;
  }

  /// Drops operators if there is no room for all.
  void trim() { make_room(static_cast<BodyIndex>(slots_.size())); }

 private:
  template <class Op>
  struct Held {
    std::unique_ptr<Op> op;
    std::uint64_t turn = 0;  // when last asked for
  };
  struct Slot {
    Held<InfluenceOperator> exact;
    Held<CompactOperator> compact;
  };

  [[nodiscard]] std::unique_ptr<InfluenceOperator> build(const Particles& particles,
                                                         BodyIndex i) const {
    return std::make_unique<InfluenceOperator>(
        model_.mesher(particles.local_ring(i)), model_.element, model_.plane_state, rock_,
        particles.thickness(), decltype(model_.support)::needs_flexibility);
  }

  template <class Op>
  void keep(Held<Op>& held, std::unique_ptr<Op> op) {
    held.op = std::move(op);
    std::atomic_ref(bytes_).fetch_add(held.op->bytes());
  }
  template <class Op>
  void drop(Held<Op>& held) {
    if (held.op) bytes_ -= held.op->bytes();
    held.op.reset();
  }

  // Then exact operators stay from which compact ones were made: at 14 MPa every third particle
  // comes to need its own within 3 % of strain, and to build it again takes a fifth of all
  // checking.
  [[nodiscard]] bool has_plenty() { return std::atomic_ref(bytes_).load() < budget_ / 4; }

  // Down to seven eighths of the budget, for the search is long; exact operators first, for fewer
  // particles need theirs again. Those of particle `in_use` stay.
  void make_room(BodyIndex in_use) {
    if (bytes_ <= budget_) return;
    const std::size_t goal = budget_ - budget_ / 8;
    drop_oldest(&Slot::exact, in_use, goal);
    drop_oldest(&Slot::compact, in_use, goal);
  }
  template <class Op>
  void drop_oldest(Held<Op> Slot::*kind, BodyIndex in_use, std::size_t goal) {
    if (bytes_ <= goal) return;
    oldest_.clear();
    for (BodyIndex i = 0; i < slots_.size(); ++i)
      if ((slots_[i].*kind).op && i != in_use) oldest_.emplace_back((slots_[i].*kind).turn, i);
    std::sort(oldest_.begin(), oldest_.end());
    for (const auto& [turn, i] : oldest_) {
      if (bytes_ <= goal) return;
      drop(slots_[i].*kind);
    }
  }

  StressPart model_;
  Rock rock_;
  std::vector<Slot> slots_;
  std::vector<std::pair<std::uint64_t, BodyIndex>> oldest_;
  std::size_t budget_ = default_budget;
  std::size_t bytes_ = 0;
  std::uint64_t turn_ = 0;
};

}  // namespace riprap
