// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The pairs of each body.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <riprap/particle/particles.hpp>

namespace riprap {

/// For each body, its sides of pairs: side 2k is body a of pair k, side 2k + 1 its body b.
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
    std::uint32_t side = 0;
    for (const auto& pair : pairs) {
      sides_[starts_[pair.a + 1]++] = side++;
      sides_[starts_[pair.b + 1]++] = side++;
    }
  }

  /// Of body i, in rising order.
  [[nodiscard]] std::span<const std::uint32_t> of(BodyIndex i) const {
    return {sides_.data() + starts_[i], sides_.data() + starts_[i + 1]};
  }

 private:
  std::vector<std::uint32_t> starts_;
  std::vector<std::uint32_t> sides_;
};

}  // namespace riprap
