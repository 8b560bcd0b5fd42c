// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A body force that is linear over a triangle, spread over its nodes by quadrature: independent of
/// the mass matrices of elements.

#include <array>
#include <cstddef>

#include <riprap/core/vec2.hpp>

namespace riprap {

/// Consistent forces of the nodes over the area: means over the triangle of `force(x)`, linear in
/// x, times the shape functions, 3 linear or 6 quadratic ones. The middles of the sides integrate
/// the former exactly, the four points of degree three of Strang and Fix (1973) the latter.
template <std::size_t Nodes, class Force>
[[nodiscard]] std::array<Vec2, Nodes> body_force_shares(const std::array<Vec2, 3>& corners,
                                                        Force&& force) {
  static_assert(Nodes == 3 || Nodes == 6);
  std::array<Vec2, Nodes> shares;
  shares.fill(Vec2{0, 0});
  const auto add = [&](const std::array<double, 3>& at, double weight) {
    const Vec2 here =
        weight * Vec2(force(Vec2(at[0] * corners[0] + at[1] * corners[1] + at[2] * corners[2])));
    for (std::size_t k = 0; k < 3; ++k) {
      const double next = at[(k + 1) % 3];
      shares[k] += (Nodes == 3 ? at[k] : at[k] * (2 * at[k] - 1)) * here;
      if constexpr (Nodes == 6) shares[k + 3] += 4 * at[k] * next * here;
    }
  };
  if constexpr (Nodes == 3) {
    for (const auto& at : {std::array{0.5, 0.5, 0.0}, {0.0, 0.5, 0.5}, {0.5, 0.0, 0.5}})
      add(at, 1.0 / 3);
  } else {
    add({1.0 / 3, 1.0 / 3, 1.0 / 3}, -27.0 / 48);
    for (const auto& at : {std::array{0.6, 0.2, 0.2}, {0.2, 0.6, 0.2}, {0.2, 0.2, 0.6}})
      add(at, 25.0 / 48);
  }
  return shares;
}

}  // namespace riprap
