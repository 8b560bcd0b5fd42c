// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The 6-node triangle with quadratic displacements: strains are linear.

#include <array>
#include <cstddef>

#include <riprap/stress/element/concepts.hpp>

namespace riprap {

/// Fraeijs de Veubeke (1965); Zienkiewicz and Taylor, The Finite Element Method. The sides are
/// straight, so that the stiffness is integrated exactly by three points. Stress is sampled at the
/// centroids of the four triangles into which the middles of the sides divide the element.
struct LinearStrainTriangle {
  static constexpr std::size_t nodes = 6;
  static constexpr std::array<TrianglePoint, 4> sampling_points{
      TrianglePoint{{2.0 / 3, 1.0 / 6, 1.0 / 6}, 0.25},
      TrianglePoint{{1.0 / 6, 2.0 / 3, 1.0 / 6}, 0.25},
      TrianglePoint{{1.0 / 6, 1.0 / 6, 2.0 / 3}, 0.25},
      TrianglePoint{{1.0 / 3, 1.0 / 3, 1.0 / 3}, 0.25}};
  static constexpr std::array<TrianglePoint, 3> integration_points{
      TrianglePoint{{2.0 / 3, 1.0 / 6, 1.0 / 6}, 1.0 / 3},
      TrianglePoint{{1.0 / 6, 2.0 / 3, 1.0 / 6}, 1.0 / 3},
      TrianglePoint{{1.0 / 6, 1.0 / 6, 2.0 / 3}, 1.0 / 3}};

  /// Shape functions: L_k (2 L_k - 1) of corner k, 4 L_k L_k+1 of the middle of its side.
  [[nodiscard]] StrainDisplacement<6> strain_displacement(const std::array<Vec2, 3>& corners,
                                                          const Barycentric& at) const {
    const double twice_area = cross(corners[1] - corners[0], corners[2] - corners[0]);
    const auto gradient = [&](std::size_t k) -> Vec2 {  // of L_k
      return perpendicular(corners[(k + 2) % 3] - corners[(k + 1) % 3]) / twice_area;
    };
    StrainDisplacement<6> b = StrainDisplacement<6>::Zero();
    const auto set_node = [&](std::size_t node, const Vec2& g) {
      const auto column = static_cast<Eigen::Index>(2 * node);
      b(0, column) = g.x();
      b(1, column + 1) = g.y();
      b(2, column) = g.y();
      b(2, column + 1) = g.x();
    };
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      set_node(k, (4 * at[k] - 1) * gradient(k));
      set_node(k + 3, 4 * at[next] * gradient(k) + 4 * at[k] * gradient(next));
    }
    return b;
  }

  /// Products of shape functions, integrated exactly.
  [[nodiscard]] NodalMass<6> mass(const std::array<Vec2, 3>& corners) const {
    const double unit = 0.5 * cross(corners[1] - corners[0], corners[2] - corners[0]) / 180;
    NodalMass<6> m;
    m << 6, -1, -1, 0, -4, 0,  //
        -1, 6, -1, 0, 0, -4,   //
        -1, -1, 6, -4, 0, 0,   //
        0, 0, -4, 32, 16, 16,  //
        -4, 0, 0, 16, 32, 16,  //
        0, -4, 0, 16, 16, 32;
    m *= unit;
    return m;
  }
};

static_assert(Element<LinearStrainTriangle>);

}  // namespace riprap
