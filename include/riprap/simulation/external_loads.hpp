// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Forces and moments that a program puts on bodies.

#include <cstddef>
#include <span>
#include <vector>

#include <riprap/core/ids.hpp>
#include <riprap/particle/body.hpp>

namespace riprap {

/// The load on each body, about its centroid; none at first.
class ExternalLoads {
 public:
  /// Of the bodies from the first to the last one that was ever loaded.
  [[nodiscard]] std::span<const Wrench> all() const { return loads_; }
  [[nodiscard]] Wrench of(BodyIndex i) const { return i < loads_.size() ? loads_[i] : Wrench{}; }

  void set(BodyIndex i, const Wrench& load) {
    if (loads_.size() <= i) loads_.resize(i + 1);
    loads_[i] = load;
  }
  /// Another particle has index i now.
  void forget(BodyIndex i) {
    if (i < loads_.size()) loads_[i] = {};
  }
  /// Body i was removed; those behind it have moved up.
  void remove(BodyIndex i) {
    if (i < loads_.size()) loads_.erase(loads_.begin() + static_cast<std::ptrdiff_t>(i));
  }

  static constexpr bool names_all_members = true;
  static void for_each_field(auto& self, auto&& visit) { visit("loads", self.loads_); }

 private:
  std::vector<Wrench> loads_;
};

}  // namespace riprap
