// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <cmath>
#include <cstddef>

#include <riprap/measurement/fabric.hpp>

namespace riprap {

RIPRAP_INLINE Fabric fabric(std::span<const ContactSample> samples) {
  Fabric result;
  internal::Deviator normals;
  for (const ContactSample& s : samples) {
    require_finite("fabric: sum of a contact's normal, forces and branch vector",
                   s.normal.x() + s.normal.y() + s.normal_force + s.tangential_force +
                       s.branch.x() + s.branch.y());
    normals.add(1, s.normal, s.normal);
  }
  result.normals = normals.anisotropy(static_cast<double>(samples.size()));

  const double a = result.normals.coefficient;
  const Vec2 major{std::cos(result.normals.direction), std::sin(result.normals.direction)};
  double weights = 0;
  double force = 0;
  double branch = 0;
  internal::Deviator normal_force;
  internal::Deviator tangential_force;
  internal::Deviator normal_branch;
  internal::Deviator tangential_branch;
  for (const ContactSample& s : samples) {
    const double along = major.dot(s.normal);
    const double density = 1 + a * (2 * along * along - 1);
    if (density <= 0) {
      ++result.left_out;
      continue;
    }
    const double w = 1 / density;
    const Vec2 tangent = perpendicular(s.normal);
    const double l_n = s.branch.dot(s.normal);
    const double l_t = s.branch.dot(tangent);
    weights += w;
    force += w * s.normal_force;
    branch += w * l_n;
    normal_force.add(w * s.normal_force, s.normal, s.normal);
    tangential_force.add(w * s.tangential_force, tangent, s.normal);
    normal_branch.add(w * l_n, s.normal, s.normal);
    tangential_branch.add(w * l_t, tangent, s.normal);
  }
  if (weights == 0) return result;
  result.mean_normal_force = force / weights;
  result.mean_branch = branch / weights;
  result.normal_forces = normal_force.anisotropy(force);
  result.tangential_forces = tangential_force.anisotropy(force);
  result.normal_branches = normal_branch.anisotropy(branch);
  result.tangential_branches = tangential_branch.anisotropy(branch);
  return result;
}

}  // namespace riprap
