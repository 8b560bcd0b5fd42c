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
/// any owner, follows its pairs by `carry`. Between two searches pairs are appended only, and those
/// before them stay where they are: arrays that were not carried since the search may still follow.
class PairMap {
 public:
  static constexpr std::uint32_t not_present = std::numeric_limits<std::uint32_t>::max();

  /// The revisions that the map connects; see PairList::revision.
  [[nodiscard]] std::uint64_t from() const { return from_; }
  [[nodiscard]] std::uint64_t to() const { return to_; }
  /// Whether arrays of a revision can be carried: of `from()`, and of the search before it.
  [[nodiscard]] bool leads_from(std::uint64_t revision) const {
    return revision == from_ || revision == from_search_;
  }
  [[nodiscard]] std::size_t size() const { return size_; }
  /// Index of pair k in the revision before; `not_present` for a new pair.
  [[nodiscard]] std::uint32_t previous_index(std::size_t k) const {
    if (!appends_) return previous_[k];
    return k < kept_ ? static_cast<std::uint32_t>(k) : not_present;
  }

  /// Moves the entries of `array`, `each` for a pair, to revision `to()` from one that the map
  /// leads from; those of new pairs are `fresh`. `workspace` keeps its memory.
  template <class T>
  void carry(std::vector<T>& array, std::vector<T>& workspace, const T& fresh,
             std::size_t each = 1) const {
    if (appends_) {
      array.resize(each * size_, fresh);
      return;
    }
    workspace.clear();
    for (const std::size_t earlier : previous_)
      for (std::size_t e = each * earlier; e < each * (earlier + 1); ++e)
        workspace.push_back(e < array.size() ? array[e] : fresh);
    std::swap(array, workspace);
  }

  /// Starts the map to a new revision; `add` its pairs in order, then `finish`.
  void begin() { previous_.clear(); }
  void add(std::uint32_t previous) { previous_.push_back(previous); }
  void finish(std::uint64_t revision) {
    from_search_ = search_;
    search_ = revision;
    appends_ = false;
    next(previous_.size(), revision);
  }
  /// The map to a revision with more pairs, `size` in all, behind those that stay.
  void append(std::size_t size, std::uint64_t revision) {
    from_search_ = search_;
    appends_ = true;
    next(size, revision);
  }

 private:
  void next(std::size_t size, std::uint64_t revision) {
    kept_ = size_;
    size_ = size;
    from_ = to_;
    to_ = revision;
  }

  std::vector<std::uint32_t> previous_;  // by the last search
  bool appends_ = false;
  std::size_t kept_ = 0;  // number of pairs of `from_`
  std::size_t size_ = 0;
  std::uint64_t from_ = 0;
  std::uint64_t to_ = 0;
  std::uint64_t search_ = 0;       // revision of the last search
  std::uint64_t from_search_ = 0;  // of the one whose pairs are the first of `from_`
};

}  // namespace riprap
