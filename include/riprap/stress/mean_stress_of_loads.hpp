// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Mean stress of one particle from its contact loads, without finite elements.

#include <span>

#include <riprap/core/stress2.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/geometry/second_moments.hpp>
#include <riprap/stress/contact_loads.hpp>

namespace riprap {

/// [Pa], compression positive, in laboratory axes: -1/V times the sum of the symmetric products of
/// arm and force (Love 1927, Weber 1966), of contact forces and of the inertia forces that balance
/// them (inertia relief). Those of the acceleration of the centroid cancel; those of the angular
/// acceleration M / I, with M the moment of the contacts, do so where the second moments of area
/// about both axes are equal. By virtual work it is the mean of the element stresses on any mesh,
/// if the loads act on the boundary.
/// @param ring of the particle, in laboratory coordinates, @param centroid of it
/// @param area of it [m^2], @param thickness [m]
[[nodiscard]] inline Stress2 mean_stress(std::span<const ContactLoad> loads, Ring ring,
                                         const Vec2& centroid, double area, double thickness) {
  Stress2 sum;
  double moment = 0;
  for (const ContactLoad& load : loads) {
    sum += symmetric_product(load.arm_lab, load.force_lab);
    moment += cross(load.arm_lab, load.force_lab);
  }
  if (moment != 0) {
    const SecondMoments m = second_moments(ring, centroid);
    sum += (moment / (m.xx + m.yy)) * Stress2{m.xy, -m.xy, 0.5 * (m.yy - m.xx)};
  }
  return (-1 / (area * thickness)) * sum;
}

}  // namespace riprap
