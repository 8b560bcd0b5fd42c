// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The pairs of neighbours of a simulation: searched when they may have become incomplete, followed
/// when a particle breaks.

#include <cstddef>
#include <utility>

#include <riprap/contact/broad_phase/pair_search.hpp>
#include <riprap/contact/neighbour_list/concepts.hpp>
#include <riprap/contact/pair/excluded_pairs.hpp>
#include <riprap/contact/pair/pair_table.hpp>
#include <riprap/core/execution/concepts.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// A table of pairs, the search that fills it, and the neighbour list that says when.
/// @tparam Excluded pairs that the search leaves out
template <class ContactType, BroadPhase Broad, class Domain, NeighbourList List,
          class Excluded = NoExcludedPairs>
class Neighbours {
 public:
  using State = typename List::template State<Domain>;

  explicit Neighbours(Broad broad) : search_(std::move(broad)) {}

  [[nodiscard]] const PairTable<ContactType>& table() const { return table_; }
  [[nodiscard]] PairTable<ContactType>& table() { return table_; }
  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] State& state() { return state_; }

  /// Whether the list has to be searched for the present poses.
  template <Execution E>
  [[nodiscard]] bool is_stale(const Particles& particles, const Domain& domain,
                              const E& execution) {
    return state_.is_stale(particles, domain, execution);
  }
  void search(const Particles& particles, const Domain& domain) {
    PairList<ContactType>& list = table_.list();
    list.begin();
    const PairExtent extent = search_.visit_pairs(particles, domain, List::uses_skin,
                                                  [&](BodyIndex a, BodyIndex b, const auto& image) {
                                                    if (!excluded_.contains(a, b, image))
                                                      list.add(a, b, image);
                                                  });
    list.finish();
    state_.rebuilt(particles, domain, extent);
    table_.arrange(particles);
    is_complete_ = true;
  }

  /// Leaves pairs out from the next search on, which must come before the next use.
  void exclude(Excluded pairs) {
    excluded_ = std::move(pairs);
    invalidate();
  }
  /// Makes the next `is_stale` true.
  void invalidate() {
    is_complete_ = false;
    state_.invalidate();
  }
  /// Whether the table has the pairs of all bodies.
  [[nodiscard]] bool is_complete() const { return is_complete_; }
  /// Body i was removed, and those behind it have moved up.
  void remove(BodyIndex i) {
    table_.list().remove(i);
    invalidate();
  }
  /// The body `whole` at the index `parent` has become the pieces there and at `second`, above all
  /// others; one piece, if the two are equal. A neighbour list that does not follow has to be
  /// searched.
  void divide(const Particles& particles, const Body& whole, BodyIndex parent, BodyIndex second) {
    if constexpr (requirements::FollowsPieces<State>) {
      if (!is_complete_) return;
      state_.divide(particles, whole, parent, second);
      if (second != parent) table_.divide(particles, parent, second);
    } else {
      invalidate();
    }
  }
  /// Without pairs, as at the start.
  void clear() {
    table_.list().clear();
    state_ = State{};
    is_complete_ = false;
  }

 private:
  PairSearch<Broad, Domain> search_;
  [[no_unique_address]] State state_;
  [[no_unique_address]] Excluded excluded_;
  PairTable<ContactType> table_;
  bool is_complete_ = false;
};

}  // namespace riprap
