// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Several end conditions at once.

#include <algorithm>
#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/experiment/loading_concepts.hpp>

namespace riprap {

namespace internal {

/// What AnyOf and AllOf share; `One` is a variant of conditions. All parts are asked at every step.
template <class One>
struct Conditions {
  std::vector<One> parts{};

  template <class View>
  void begin(const View& view) {
    for (One& part : parts) std::visit([&](auto& c) { begin_part(c, view); }, part);
  }
  void validate(const std::string& owner) const {
    require(!parts.empty(), owner + ".parts", 0, "must be one at least");
    for (const One& part : parts) std::visit([&](const auto& c) { validate_part(c, owner); }, part);
  }

  static constexpr bool names_all_members = false;
  static void for_each_field(auto& self, auto&& visit) {
    for (std::size_t k = 0; k < self.parts.size(); ++k)
      std::visit([&](auto& c) { visit(("part_" + std::to_string(k)).c_str(), c); }, self.parts[k]);
  }

 protected:
  template <class View>
  [[nodiscard]] std::size_t count_reached(const View& view) {
    std::size_t count = 0;
    for (One& part : parts) count += std::visit([&](auto& c) { return ask(c, view); }, part);
    return count;
  }
  template <class View>
  [[nodiscard]] static double share(const One& part, const View& view) {
    return std::visit([&](const auto& c) { return share_done(c, view); }, part);
  }
};

}  // namespace internal

/// One of the conditions is enough.
template <class One>
struct AnyOf : internal::Conditions<One> {
  static constexpr const char* name = "any";

  template <class View>
  [[nodiscard]] bool reached(const View& view) {
    return this->count_reached(view) > 0;
  }
  template <class View>
  [[nodiscard]] double done(const View& view) const {
    double most = 0;
    for (const One& part : this->parts) most = std::max(most, this->share(part, view));
    return most;
  }
};

/// All conditions must hold after the same step. One that is asked at checks only holds there only.
template <class One>
struct AllOf : internal::Conditions<One> {
  static constexpr const char* name = "all";

  template <class View>
  [[nodiscard]] bool reached(const View& view) {
    return this->count_reached(view) == this->parts.size();
  }
  template <class View>
  [[nodiscard]] double done(const View& view) const {
    double least = 1;
    for (const One& part : this->parts) least = std::min(least, this->share(part, view));
    return least;
  }
};

}  // namespace riprap
