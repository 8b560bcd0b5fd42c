// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// From one revision of the pair list to the next: moves arrays that run parallel to the pairs.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include <riprap/core/compiler.hpp>

namespace riprap {

/// Which pair of a revision was which of the one before. An array with entries for each pair, of
/// any owner, follows its pairs by `carry`.
class PairMap {
 public:
  static constexpr std::uint32_t not_present = std::numeric_limits<std::uint32_t>::max();

  /// The revisions that the map connects; see PairList::revision.
  [[nodiscard]] std::uint64_t from() const { return from_; }
  [[nodiscard]] std::uint64_t to() const { return to_; }
  [[nodiscard]] std::size_t size() const { return previous_.size(); }
  /// Index of pair k in the revision before; `not_present` for a new pair.
  [[nodiscard]] std::uint32_t previous_index(std::size_t k) const { return previous_[k]; }

  /// Moves the entries of `array`, `each` for a pair, from revision `from()` to `to()`; those of
  /// new pairs are `fresh`. `workspace` keeps its memory.
  template <class T>
  void carry(std::vector<T>& array, std::vector<T>& workspace, const T& fresh,
             std::size_t each = 1) const {
    workspace.clear();
    for (const std::uint32_t earlier : previous_)
      for (std::size_t e = 0; e < each; ++e)
        workspace.push_back(earlier == not_present ? fresh : array[each * earlier + e]);
    std::swap(array, workspace);
  }

  /// Starts the map to a new revision; `add` its pairs in order, then `finish`.
  void begin() { previous_.clear(); }
  void add(std::uint32_t previous) { previous_.push_back(previous); }
  void finish(std::uint64_t revision) {
    from_ = to_;
    to_ = revision;
  }

 private:
  std::vector<std::uint32_t> previous_;
  std::uint64_t from_ = 0;
  std::uint64_t to_ = 0;
};

}  // namespace riprap
