// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A trigger by the loads chosen at run time, for programs with options.

#include <variant>

#include <riprap/breakage/trigger/concepts.hpp>

namespace riprap {

/// Holds one of several triggers that need no elements, and passes the particle on to it. Strengths
/// that scatter go around it: `WithWeibullStrength<TriggerChoice<...>>`.
template <LoadTrigger... Triggers>
  requires(!HasStrengthFactor<Triggers> && ...)
struct TriggerChoice {
  std::variant<Triggers...> chosen;

  [[nodiscard]] FailureMode operator()(const LoadedParticle& particle) const {
    return std::visit([&](const auto& trigger) -> FailureMode { return trigger(particle); },
                      chosen);
  }

  static void for_each_field(auto& self, auto&& visit) { visit("chosen", self.chosen); }

  void validate() const {
    std::visit([](const auto& trigger) { riprap::validate(trigger); }, chosen);
  }
};

}  // namespace riprap
