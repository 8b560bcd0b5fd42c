// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The pairs of each body.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <riprap/core/ids.hpp>

namespace riprap {

/// One of the two bodies of a pair: entry `2 * pair` of an array by sides is that of body a, the
/// next one that of body b.
class PairSide {
 public:
  PairSide() = default;
  PairSide(std::size_t pair, bool is_b)
      : value_(2 * static_cast<std::uint32_t>(pair) + static_cast<std::uint32_t>(is_b)) {}

  [[nodiscard]] std::uint32_t pair() const { return value_ / 2; }
  [[nodiscard]] bool is_b() const { return value_ % 2 != 0; }
  /// Index in an array by sides.
  [[nodiscard]] std::uint32_t index() const { return value_; }

  friend bool operator==(PairSide, PairSide) = default;

 private:
  std::uint32_t value_ = 0;
};

/// For each body, its sides of pairs.
class PairIndex {
 public:
  /// @param pairs of bodies `a` and `b` below `bodies`
  template <class Pairs>
  void build(const Pairs& pairs, std::size_t bodies) {
    ranges_.assign(bodies, {});
    for (const auto& pair : pairs) {
      ++ranges_[pair.a].last;
      ++ranges_[pair.b].last;
    }
    std::uint32_t sides = 0;
    for (Range& range : ranges_) {
      const std::uint32_t count = range.last;
      range = {sides, sides};
      sides += count;
    }
    sides_.resize(sides);
    std::size_t k = 0;
    for (const auto& pair : pairs) {
      sides_[ranges_[pair.a].last++] = {k, false};
      sides_[ranges_[pair.b].last++] = {k, true};
      ++k;
    }
  }

  /// Adds a side of a pair that follows all others of body i, which may be new.
  void add(BodyIndex i, PairSide side) {
    const auto end = static_cast<std::uint32_t>(sides_.size());
    if (i >= ranges_.size()) ranges_.resize(i + 1, {end, end});
    Range& range = ranges_[i];
    if (range.last != end) {  // the sides of the body move to the end
      for (std::uint32_t k = range.first; k < range.last; ++k) {
        const PairSide known = sides_[k];
        sides_.push_back(known);
      }
      range = {end, static_cast<std::uint32_t>(sides_.size())};
    }
    sides_.push_back(side);
    ++range.last;
  }

  /// Number of bodies.
  [[nodiscard]] std::size_t size() const { return ranges_.size(); }
  /// Of body i, in the order of the pairs.
  [[nodiscard]] std::span<const PairSide> of(BodyIndex i) const {
    return {sides_.data() + ranges_[i].first, sides_.data() + ranges_[i].last};
  }

 private:
  struct Range {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
  };

  std::vector<Range> ranges_;  // of each body
  std::vector<PairSide> sides_;
};

}  // namespace riprap
