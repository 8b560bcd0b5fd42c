// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A support chosen at run time: one more model of the role, for programs with options.

#include <span>
#include <variant>

#include <riprap/stress/support/concepts.hpp>

namespace riprap {

/// Holds one of several supports and passes the loads on to it. Operators keep displacements if one
/// of the supports needs them, chosen or not.
template <Support... Supports>
struct SupportChoice {
  static constexpr bool needs_flexibility = (Supports::needs_flexibility || ...);

  std::variant<Supports...> chosen;

  void apply_reactions(std::span<BoundaryLoad> loads, const InfluenceOperator& op) const {
    std::visit([&](const auto& support) { support.apply_reactions(loads, op); }, chosen);
  }
  /// That of the chosen one.
  [[nodiscard]] bool is_linear() const {
    return std::visit(
        [](const auto& support) {
          if constexpr (requires { support.is_linear(); })
            return bool{support.is_linear()};
          else
            return false;
        },
        chosen);
  }

  static void for_each_field(auto& self, auto&& visit) { visit("chosen", self.chosen); }

  void validate() const {
    std::visit([](const auto& support) { riprap::validate(support); }, chosen);
  }
};

}  // namespace riprap
