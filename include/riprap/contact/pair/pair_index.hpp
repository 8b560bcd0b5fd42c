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
    // Counted two places on, so that filling leaves every start where it belongs.
    starts_.assign(bodies + 2, 0);
    for (const auto& pair : pairs) {
      ++starts_[pair.a + 2];
      ++starts_[pair.b + 2];
    }
    for (std::size_t i = 2; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    sides_.resize(starts_.back());
    std::size_t k = 0;
    for (const auto& pair : pairs) {
      sides_[starts_[pair.a + 1]++] = {k, false};
      sides_[starts_[pair.b + 1]++] = {k, true};
      ++k;
    }
  }

  /// Of body i, in the order of the pairs.
  [[nodiscard]] std::span<const PairSide> of(BodyIndex i) const {
    return {sides_.data() + starts_[i], sides_.data() + starts_[i + 1]};
  }

 private:
  std::vector<std::uint32_t> starts_;
  std::vector<PairSide> sides_;
};

}  // namespace riprap
