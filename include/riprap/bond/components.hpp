// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Connected components of bodies that are joined two by two.

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include <riprap/core/ids.hpp>

namespace riprap {

/// A forest of bodies; the name of a component is its lowest body.
class Components {
 public:
  explicit Components(std::size_t bodies) : above_(bodies) {
    std::iota(above_.begin(), above_.end(), BodyIndex{0});
  }

  /// The lowest body of the component of body i.
  [[nodiscard]] BodyIndex of(BodyIndex i) {
    while (above_[i] != i) {
      above_[i] = above_[above_[i]];
      i = above_[i];
    }
    return i;
  }
  /// Returns whether the two were not connected before.
  bool join(BodyIndex i, BodyIndex j) {
    BodyIndex low = of(i);
    BodyIndex high = of(j);
    if (low == high) return false;
    if (low > high) std::swap(low, high);
    above_[high] = low;
    return true;
  }

 private:
  std::vector<BodyIndex> above_;
};

}  // namespace riprap
