// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The 3-node triangle with linear displacements: the paper's element.

#include <algorithm>
#include <array>
#include <cstddef>

#include <riprap/stress/element/concepts.hpp>

namespace riprap {

/// Turner, Clough, Martin and Topp (1956); e.g. Zienkiewicz and Taylor, The Finite Element Method.
struct ConstantStrainTriangle {
  static constexpr std::size_t nodes = 3;
  static constexpr auto sampling_points = centroid_rule;
  static constexpr auto integration_points = centroid_rule;

  /// The same at every point.
  [[nodiscard]] StrainDisplacement<3> strain_displacement(const std::array<Vec2, 3>& corners,
                                                          const Barycentric& = {}) const {
    const double twice_area = cross(corners[1] - corners[0], corners[2] - corners[0]);
    StrainDisplacement<3> b;
    std::fill_n(b.data(), 18, 0.0);
    for (int i = 0; i < 3; ++i) {
      const Vec2& next = corners[static_cast<std::size_t>((i + 1) % 3)];
      const Vec2& last = corners[static_cast<std::size_t>((i + 2) % 3)];
      // Gradient of the shape function of node i.
      const Vec2 gradient = perpendicular(last - next) / twice_area;
      b(0, 2 * i) = gradient.x();
      b(1, 2 * i + 1) = gradient.y();
      b(2, 2 * i) = gradient.y();
      b(2, 2 * i + 1) = gradient.x();
    }
    return b;
  }

  [[nodiscard]] NodalMass<3> mass(const std::array<Vec2, 3>& corners) const {
    const double area = 0.5 * cross(corners[1] - corners[0], corners[2] - corners[0]);
    NodalMass<3> m;
    std::fill_n(m.data(), 9, area / 12);
    for (int i = 0; i < 3; ++i) m(i, i) = area / 6;
    return m;
  }
};

static_assert(Element<ConstantStrainTriangle>);

}  // namespace riprap
