// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <numbers>

#include <riprap/measurement/stress_force_fabric.hpp>

namespace riprap {

RIPRAP_INLINE double sin_phi_from_fabric(const Fabric& f, double axis) {
  return (f.normals.along(axis) + f.normal_forces.along(axis) + f.tangential_forces.along(axis)) /
         (2 + f.normals.coefficient * f.normal_forces.along(f.normals.direction));
}

RIPRAP_INLINE double sin_phi_from_fabric_simplified(const Fabric& f, double axis) {
  return 0.5 *
         (f.normals.along(axis) + f.normal_forces.along(axis) + f.tangential_forces.along(axis));
}

RIPRAP_INLINE Stress2 stress_from_fabric(const Fabric& f) {
  constexpr int directions = 16;
  Stress2 sum;
  for (int k = 0; k < directions; ++k) {
    const double theta = 2 * std::numbers::pi * k / directions;
    const Vec2 n{std::cos(theta), std::sin(theta)};
    const Vec2 t = perpendicular(n);
    const double density = 1 + f.normals.along(theta);
    const auto radial = [theta](double mean, const Anisotropy& c) {
      return mean * (1 + c.along(theta));
    };
    const auto shear = [theta](double mean, const Anisotropy& c) {
      return -mean * c.coefficient * std::sin(2 * (theta - c.direction));
    };
    const Vec2 force = radial(f.mean_normal_force, f.normal_forces) * n +
                       shear(f.mean_normal_force, f.tangential_forces) * t;
    const Vec2 branch = radial(f.mean_branch, f.normal_branches) * n +
                        shear(f.mean_branch, f.tangential_branches) * t;
    sum += density * Stress2{force.x() * branch.x(), force.y() * branch.y(),
                             0.5 * (force.x() * branch.y() + force.y() * branch.x())};
  }
  return (1.0 / directions) * sum;
}

}  // namespace riprap
