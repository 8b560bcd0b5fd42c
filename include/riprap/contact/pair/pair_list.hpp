// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Pair list: pairs of neighbours in the order of their bodies, with their contacts.

#include <algorithm>
#include <compare>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include <riprap/contact/pair/contact.hpp>
#include <riprap/contact/pair/pair_map.hpp>
#include <riprap/core/ids.hpp>
#include <riprap/core/splitmix64.hpp>

namespace riprap {

/// Pairs sorted by (a, b, image), a < b: forces are summed in that order, whatever the broad phase.
/// In a periodic domain a pair is a body and one image of another, so that two bodies may form
/// several pairs.
template <class ContactType>
class PairList {
 public:
  using Image = decltype(ContactType::image);

  [[nodiscard]] std::span<const ContactType> pairs() const { return pairs_; }
  [[nodiscard]] std::span<ContactType> pairs() { return pairs_; }
  [[nodiscard]] std::size_t size() const { return pairs_.size(); }

  /// Revision of the list; changes whenever the sequence of pairs changes.
  [[nodiscard]] std::uint64_t revision() const { return map_.to(); }
  /// From the revision before to this one.
  [[nodiscard]] const PairMap& map() const { return map_; }

  /// A new list: `add` its pairs in any order, then `finish`.
  void begin() { keys_.clear(); }
  void add(BodyIndex a, BodyIndex b, const Image& image) { keys_.push_back({a, b, image}); }
  /// Pairs that were in the list before keep their contact.
  void finish() {
    std::sort(keys_.begin(), keys_.end());
    next_pairs_.clear();
    map_.begin();
    std::uint32_t former = 0;
    for (const Key& k : keys_) {
      while (former < pairs_.size() && key(pairs_[former]) < k) ++former;
      const bool kept = former < pairs_.size() && key(pairs_[former]) == k;
      if (kept)
        next_pairs_.push_back(pairs_[former]);
      else
        next_pairs_.push_back({.a = k.a, .b = k.b, .image = k.image});
      map_.add(kept ? former : PairMap::not_present);
    }
    finish_revision();
  }

  /// Body i is gone, and those behind it have moved up by one: so do their pairs, in their order.
  void remove(BodyIndex i) {
    keys_.clear();
    next_pairs_.clear();
    map_.begin();
    for (std::uint32_t k = 0; k < pairs_.size(); ++k) {
      if (pairs_[k].a == i || pairs_[k].b == i) continue;
      next_pairs_.push_back(pairs_[k]);
      if (next_pairs_.back().a > i) --next_pairs_.back().a;
      if (next_pairs_.back().b > i) --next_pairs_.back().b;
      keys_.push_back(key(next_pairs_.back()));
      map_.add(k);
    }
    finish_revision();
  }

  void clear() { pairs_.clear(); }

  /// The pair with the bodies and image of another, if it is in the list.
  [[nodiscard]] ContactType* find(const ContactType& of) {
    const auto found = std::ranges::lower_bound(pairs_, key(of), {}, key);
    return found != pairs_.end() && key(*found) == key(of) ? &*found : nullptr;
  }
  /// The same, if it touches.
  [[nodiscard]] ContactType* find_touching(const ContactType& of) {
    ContactType* const found = find(of);
    return found && found->touching ? found : nullptr;
  }

 private:
  struct Key {
    BodyIndex a = 0;
    BodyIndex b = 0;
    [[no_unique_address]] Image image{};
    friend auto operator<=>(const Key&, const Key&) = default;
  };
  [[nodiscard]] static Key key(const ContactType& contact) {
    return {contact.a, contact.b, contact.image};
  }
  void finish_revision() {
    std::swap(pairs_, next_pairs_);
    std::uint64_t revision = keys_.size();
    for (const Key& k : keys_)
      revision = splitmix64(revision ^ (static_cast<std::uint64_t>(k.a) << 32 | k.b));
    map_.finish(revision);
  }

  std::vector<ContactType> pairs_;
  PairMap map_;
  // Workspaces of a new list.
  std::vector<Key> keys_;
  std::vector<ContactType> next_pairs_;
};

}  // namespace riprap
