// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A criterion chosen at run time: one more model of the role, for programs with options.

#include <concepts>
#include <variant>

#include <riprap/breakage/criterion/concepts.hpp>

namespace riprap {

/// Holds one of several criteria and passes every question on to it.
template <Criterion... Criteria>
  requires(!MaterialCriterion<Criteria> && ...)  // put it into a CriterionOfRock instead
struct CriterionChoice {
  std::variant<Criteria...> chosen;

  [[nodiscard]] double major_stress_at_failure(double minor) const {
    return std::visit([minor](const auto& c) { return double(c.major_stress_at_failure(minor)); },
                      chosen);
  }
  [[nodiscard]] double tensile_strength() const {
    return std::visit([](const auto& c) { return double(c.tensile_strength()); }, chosen);
  }
  [[nodiscard]] double friction_angle(double minor) const {
    return std::visit([minor](const auto& c) { return riprap::friction_angle(c, minor); }, chosen);
  }
  [[nodiscard]] PrincipalValues extreme_stresses(const PrincipalValues& in_plane) const
    requires(OutOfPlaneCriterion<Criteria> || ...)
  {
    return std::visit([&](const auto& c) { return riprap::extreme_stresses(c, in_plane); }, chosen);
  }

  static void for_each_field(auto& self, auto&& visit) { visit("chosen", self.chosen); }

  void validate() const {
    std::visit([](const auto& c) { riprap::validate(c); }, chosen);
  }
};

}  // namespace riprap
