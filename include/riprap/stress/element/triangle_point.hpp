// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Points of a triangle, to sample at and to integrate by.

#include <array>
#include <cmath>
#include <cstddef>

#include <riprap/core/vec2.hpp>

namespace riprap {

/// Barycentric (area) coordinates: the weights of the three corners [-]; their sum is 1.
using Barycentric = std::array<double, 3>;

/// A point of a triangle, and the share of the triangle's area that it stands for.
struct TrianglePoint {
  Barycentric at{1.0 / 3, 1.0 / 3, 1.0 / 3};
  double share = 1;  ///< [-]

  /// The same bytes as Mesh::centroid at the centroid.
  [[nodiscard]] Vec2 position(const std::array<Vec2, 3>& corners) const {
    if (at[0] == at[1] && at[1] == at[2]) return (corners[0] + corners[1] + corners[2]) / 3;
    return at[0] * corners[0] + at[1] * corners[1] + at[2] * corners[2];
  }
};

/// The centroid, which stands for the whole triangle: integrates linear functions exactly.
inline constexpr std::array<TrianglePoint, 1> centroid_rule{};

/// Whether the points stand for the whole triangle: shares above zero that sum to 1, as do the
/// coordinates of every point. The tolerance is for thirds and sixths in double precision.
template <std::size_t N>
[[nodiscard]] constexpr bool is_triangle_rule(const std::array<TrianglePoint, N>& points) {
  const auto is_one = [](double sum) { return sum > 1 - 1e-12 && sum < 1 + 1e-12; };
  double shares = 0;
  for (const TrianglePoint& point : points) {
    if (!(point.share > 0) || !is_one(point.at[0] + point.at[1] + point.at[2])) return false;
    shares += point.share;
  }
  return is_one(shares);
}

/// Whether every point stands for as much of the triangle as the others.
template <std::size_t N>
[[nodiscard]] constexpr bool has_equal_shares(const std::array<TrianglePoint, N>& points) {
  for (const TrianglePoint& point : points) {
    const double share = static_cast<double>(N) * point.share;
    if (share <= 1 - 1e-12 || share >= 1 + 1e-12) return false;
  }
  return true;
}

}  // namespace riprap
