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

/// What AnyOf and AllOf share; `One` is a variant of conditions. Every part is evaluated at every
/// step.
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

namespace internal {

/// The alternative of a variant that combines conditions as `Of` does.
template <template <class> class Of, class Variant>
struct Combination;
template <template <class> class Of, class First, class... T>
struct Combination<Of, std::variant<First, T...>> : Combination<Of, std::variant<T...>> {};
template <template <class> class Of, class One, class... T>
struct Combination<Of, std::variant<Of<One>, T...>> {
  using Type = Of<One>;
  using Part = One;
};

/// A control or a condition as a variant with more alternatives than the one it comes from.
template <class Wider, class T>
[[nodiscard]] Wider widened(const T& part) {
  return Wider(part);
}
template <class Wider, template <class> class Of, class One>
  requires requires(Of<One> combination) { combination.parts; }
[[nodiscard]] Wider widened(const Of<One>& combination) {
  typename Combination<Of, Wider>::Type all;
  for (const One& part : combination.parts)
    all.parts.push_back(std::visit(
        [](const auto& c) { return widened<typename Combination<Of, Wider>::Part>(c); }, part));
  return all;
}

}  // namespace internal
}  // namespace riprap
