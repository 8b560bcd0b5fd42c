// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Gradient of a displacement field in the plane, and the strains and the rotation in it.

#include <array>
#include <cmath>

#include <riprap/core/vec2.hpp>

namespace riprap {

/// h_ij = du_i / dX_j of displacements u over positions X in a reference state [-]. Strains and
/// rotation are those of finite deformation, F = I + h = R U, and do not change when a rigid
/// rotation follows.
struct DisplacementGradient {
  double h11 = 0;
  double h12 = 0;
  double h21 = 0;
  double h22 = 0;

  DisplacementGradient& operator+=(const DisplacementGradient& o) {
    h11 += o.h11;
    h12 += o.h12;
    h21 += o.h21;
    h22 += o.h22;
    return *this;
  }
  [[nodiscard]] friend DisplacementGradient operator*(double f, const DisplacementGradient& h) {
    return {f * h.h11, f * h.h12, f * h.h21, f * h.h22};
  }

  /// 1 - det F, loss of area over the area before: positive in contraction.
  [[nodiscard]] double volumetric_strain() const { return -(h11 + h22 + (h11 * h22 - h12 * h21)); }
  /// Difference of the principal stretches of U, never below 0. Of small strains it is the diameter
  /// of Mohr's circle, eps_1 - eps_2: the largest engineering shear strain.
  [[nodiscard]] double deviatoric_strain() const { return std::hypot(h11 - h22, h12 + h21); }
  /// Angle of R [rad], counter-clockwise positive, within half a turn.
  [[nodiscard]] double rotation() const { return std::atan2(h21 - h12, 2 + h11 + h22); }
};

/// Of the linear field through three displacements. Exact to round-off of the displacements.
/// @param x corners in the reference state [m], counter-clockwise; @param u displacements [m]
[[nodiscard]] inline DisplacementGradient displacement_gradient(const std::array<Vec2, 3>& x,
                                                                const std::array<Vec2, 3>& u) {
  const Vec2 p = x[1] - x[0];
  const Vec2 q = x[2] - x[0];
  const Vec2 du = u[1] - u[0];
  const Vec2 dv = u[2] - u[0];
  const double scale = 1 / cross(p, q);
  return {scale * (du.x() * q.y() - dv.x() * p.y()), scale * (dv.x() * p.x() - du.x() * q.x()),
          scale * (du.y() * q.y() - dv.y() * p.y()), scale * (dv.y() * p.x() - du.y() * q.x())};
}

}  // namespace riprap
