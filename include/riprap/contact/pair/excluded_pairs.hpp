// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Pairs of bodies that are left out of the search for contacts.

#include <algorithm>
#include <compare>
#include <vector>

#include <riprap/core/ids.hpp>

namespace riprap {

/// No pair is left out.
struct NoExcludedPairs {
  template <class Image>
  [[nodiscard]] static constexpr bool contains(BodyIndex, BodyIndex, const Image&) {
    return false;
  }
};

/// Pairs by (a, b, image), a < b, that are added in rising order.
template <class Image>
class ExcludedPairs {
 public:
  void add(BodyIndex a, BodyIndex b, const Image& image) {
    const Key key{a, b, image};
    if (keys_.empty() || keys_.back() != key) keys_.push_back(key);
  }
  [[nodiscard]] bool contains(BodyIndex a, BodyIndex b, const Image& image) const {
    return std::binary_search(keys_.begin(), keys_.end(), Key{a, b, image});
  }

 private:
  struct Key {
    BodyIndex a = 0;
    BodyIndex b = 0;
    [[no_unique_address]] Image image{};
    friend auto operator<=>(const Key&, const Key&) = default;
  };

  std::vector<Key> keys_;
};

}  // namespace riprap
