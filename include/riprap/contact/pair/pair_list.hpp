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
#include <riprap/contact/pair/pair_index.hpp>
#include <riprap/contact/pair/pair_map.hpp>
#include <riprap/core/ids.hpp>
#include <riprap/core/splitmix64.hpp>

namespace riprap {

/// Pairs by (a, b, image), a < b: forces are summed in that order, whatever the broad phase. In a
/// periodic domain a pair is a body and one image of another, so that two bodies may form several
/// pairs.
///
/// The pairs of a search are stored in that order. Those of pieces that have come since are stored
/// behind them, break by break; `precedes` compares the places of any two.
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
    // Empty: room for the pairs of pieces without a copy of all others when they come.
    if (next_pairs_.capacity() < keys_.size() + keys_.size() / 16)
      next_pairs_.reserve(keys_.size() + keys_.size() / 4);
    map_.begin();
    std::size_t former = 0;
    for (const Key& k : keys_) {
      while (former < searched_ && key(pairs_[former]) < k) ++former;
      const bool found = former < searched_ && key(pairs_[former]) == k;
      const std::size_t known = found ? former : find_appended(k);
      if (known < pairs_.size())
        next_pairs_.push_back(pairs_[known]);
      else
        next_pairs_.push_back({.a = k.a, .b = k.b, .image = k.image});
      map_.add(known < pairs_.size() ? static_cast<std::uint32_t>(known) : PairMap::not_present);
    }
    finish_revision(keys_.size());
  }

  /// The body at `parent` has broken into a piece at the same index and one at `second`, above all
  /// others. Appends the pairs of the second piece: one for each of the parent, which the first
  /// piece keeps, and one of the two pieces.
  /// @param of_parent the sides of all its pairs
  void divide(std::span<const PairSide> of_parent, BodyIndex parent, BodyIndex second) {
    keys_.clear();
    for (const PairSide side : of_parent) {
      const ContactType& pair = pairs_[side.pair()];
      Image image = pair.image;
      if constexpr (requires { -image; })
        if (!side.is_b()) image = -image;
      keys_.push_back({side.is_b() ? pair.a : pair.b, second, image});
    }
    keys_.push_back({parent, second, Image{}});
    std::sort(keys_.begin(), keys_.end());
    std::uint64_t revision = map_.to();
    for (const Key& k : keys_) {
      pairs_.push_back({.a = k.a, .b = k.b, .image = k.image});
      revision = mixed(revision, k);
    }
    map_.append(pairs_.size(), revision);
  }

  /// Body i is gone, and those behind it have moved up by one: so do their pairs, in their order.
  void remove(BodyIndex i) {
    keys_.clear();
    next_pairs_.clear();
    map_.begin();
    std::size_t searched = 0;
    for (std::uint32_t k = 0; k < pairs_.size(); ++k) {
      if (pairs_[k].a == i || pairs_[k].b == i) continue;
      next_pairs_.push_back(pairs_[k]);
      if (next_pairs_.back().a > i) --next_pairs_.back().a;
      if (next_pairs_.back().b > i) --next_pairs_.back().b;
      keys_.push_back(key(next_pairs_.back()));
      map_.add(k);
      if (k < searched_) searched = next_pairs_.size();
    }
    finish_revision(searched);
  }

  void clear() {
    pairs_.clear();
    searched_ = 0;
    starts_.clear();
  }

  /// The pair with the bodies and image of another, if it is in the list.
  [[nodiscard]] ContactType* find(const ContactType& of) {
    const std::size_t found = find_index(key(of));
    return found < pairs_.size() ? &pairs_[found] : nullptr;
  }
  /// The same, if it touches.
  [[nodiscard]] ContactType* find_touching(const ContactType& of) {
    ContactType* const found = find(of);
    return found && found->touching ? found : nullptr;
  }

  /// Number of pairs that the last search found; the others have been appended.
  [[nodiscard]] std::size_t searched() const { return searched_; }
  /// The pair of the last search before which pair k has its place; k itself, if it is one.
  [[nodiscard]] std::size_t place(std::size_t k) const {
    return k < searched_ ? k : start_of(pairs_[k].a + 1);
  }
  /// Whether pair k comes before pair l.
  [[nodiscard]] bool precedes(std::size_t k, std::size_t l) const {
    const std::size_t at_k = place(k);
    const std::size_t at_l = place(l);
    if (at_k != at_l) return at_k < at_l;
    if (k < searched_ || l < searched_) return l < k;  // what is appended comes first
    return key(pairs_[k]) < key(pairs_[l]);
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
  [[nodiscard]] static std::uint64_t mixed(std::uint64_t revision, const Key& k) {
    return splitmix64(revision ^ (static_cast<std::uint64_t>(k.a) << 32 | k.b));
  }

  // Of the pairs of the search, the first one with the body i or a higher one as a.
  [[nodiscard]] std::size_t start_of(std::size_t i) const {
    return i < starts_.size() ? starts_[i] : searched_;
  }
  // The number of pairs, where there is none.
  [[nodiscard]] std::size_t find_index(const Key& k) const {
    const auto first = pairs_.begin() + static_cast<std::ptrdiff_t>(start_of(k.a));
    const auto last = pairs_.begin() + static_cast<std::ptrdiff_t>(start_of(k.a + std::size_t{1}));
    const auto found = std::lower_bound(
        first, last, k, [](const ContactType& pair, const Key& of) { return key(pair) < of; });
    if (found != last && key(*found) == k) return static_cast<std::size_t>(found - pairs_.begin());
    return find_appended(k);
  }
  // Appended pairs have a higher b than those before, or the same one and are in order.
  [[nodiscard]] std::size_t find_appended(const Key& k) const {
    const auto first = pairs_.begin() + static_cast<std::ptrdiff_t>(searched_);
    const auto by_b = [](const Key& p, const Key& q) { return p.b != q.b ? p.b < q.b : p < q; };
    const auto found =
        std::lower_bound(first, pairs_.end(), k, [&](const ContactType& pair, const Key& of) {
          return by_b(key(pair), of);
        });
    const bool is_found = found != pairs_.end() && key(*found) == k;
    return is_found ? static_cast<std::size_t>(found - pairs_.begin()) : pairs_.size();
  }

  void finish_revision(std::size_t searched) {
    std::swap(pairs_, next_pairs_);
    searched_ = searched;
    starts_.clear();
    for (std::size_t k = 0; k < searched_; ++k)
      while (starts_.size() <= pairs_[k].a) starts_.push_back(static_cast<std::uint32_t>(k));
    std::uint64_t revision = keys_.size();
    for (const Key& k : keys_) revision = mixed(revision, k);
    map_.finish(revision);
  }

  std::vector<ContactType> pairs_;
  std::size_t searched_ = 0;
  std::vector<std::uint32_t> starts_;  // of the pairs of each first body, in those of the search
  PairMap map_;
  // Workspaces of a new list.
  std::vector<Key> keys_;
  std::vector<ContactType> next_pairs_;
};

}  // namespace riprap
