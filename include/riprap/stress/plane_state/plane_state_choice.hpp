// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A plane state chosen at run time: one more model of the role, for programs with options.

#include <variant>

#include <riprap/stress/plane_state/concepts.hpp>

namespace riprap {

/// Holds one of several plane states and passes every question on to it.
template <PlaneState... States>
struct PlaneStateChoice {
  std::variant<States...> chosen;

  [[nodiscard]] Eigen::Matrix3d elasticity(const Rock& rock) const {
    return std::visit([&](const auto& p) { return p.elasticity(rock); }, chosen);
  }
  [[nodiscard]] double out_of_plane_stress(const Rock& rock, const Stress2& stress) const {
    return std::visit([&](const auto& p) { return double(p.out_of_plane_stress(rock, stress)); },
                      chosen);
  }

  static void for_each_field(auto& self, auto&& visit) { visit("chosen", self.chosen); }
};

}  // namespace riprap
