// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// An integrator chosen at run time: one more model of the role, for programs with options.

#include <algorithm>
#include <variant>

#include <riprap/dynamics/integrator/concepts.hpp>

namespace riprap {

/// Holds one of several integrators and passes every body on to it. Its order is the lowest of
/// theirs; it has a second kick if one of them has, which the others leave out.
template <Integrator... Integrators>
struct IntegratorChoice {
  static constexpr int order = std::min({int{Integrators::order}...});
  static constexpr bool has_second_kick = (Integrators::has_second_kick || ...);

  std::variant<Integrators...> chosen;

  void advance(Body& body, const Wrench& wrench, double time_step) const {
    std::visit([&](const auto& i) { i.advance(body, wrench, time_step); }, chosen);
  }
  void second_kick(Body& body, const Wrench& wrench, double time_step) const {
    std::visit(
        [&]<class I>(const I& i) {
          if constexpr (I::has_second_kick) i.second_kick(body, wrench, time_step);
        },
        chosen);
  }
  [[nodiscard]] double first_kick_fraction() const {
    return std::visit([](const auto& i) { return riprap::first_kick_fraction(i); }, chosen);
  }

  static void for_each_field(auto& self, auto&& visit) { visit("chosen", self.chosen); }

  void validate() const {
    std::visit([](const auto& i) { riprap::validate(i); }, chosen);
  }
};

}  // namespace riprap
