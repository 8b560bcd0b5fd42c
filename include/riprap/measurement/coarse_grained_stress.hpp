// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The stress field of a sample by coarse graining: Goldhirsch (2010), Stress, stress asymmetry and
/// couple stress: from discrete particles to continuous fields, Granular Matter 12, 239-252.

#include <cstddef>
#include <span>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/core/stress2.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/measurement/average_stress.hpp>
#include <riprap/measurement/lucy_kernel.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// A force on the segment along which it is transmitted.
struct ForceLine {
  Vec2 from{0, 0};  ///< centroid of a, or the contact point on a wall [m]
  Vec2 to{0, 0};    ///< centroid of b, likewise [m]
  Stress2 product;  ///< of the force on b and the branch from a to b, symmetric part [N m]
};

/// The contacts of a state as lines, in a periodic cell also those of the images around it.
template <class Contacts>
[[nodiscard]] std::vector<ForceLine> force_lines(const Contacts& contacts) {
  std::vector<Vec2> offsets{Vec2{0, 0}};
  if constexpr (requires { contacts.domain().offset({}); }) {
    for (int i = -1; i <= 1; ++i)
      for (int j = -1; j <= 1; ++j)
        if (i != 0 || j != 0) offsets.push_back(contacts.domain().offset({i, j}));
  }
  std::vector<ForceLine> out;
  contacts.for_each_touching([&](const auto& c) {
    const Vec2 from = c.geometry.point - c.branch_arm_a();
    const Vec2 to = c.geometry.point - c.branch_arm_b();
    const Stress2 product = symmetric_product(c.force_on_b(), c.branch());
    for (const Vec2& offset : offsets) out.push_back({from + offset, to + offset, product});
  });
  return out;
}

/// Contact stress at points [Pa], compression positive, symmetric part, in laboratory axes:
///   sigma_ij(r) = 1 / t sum of f_i l_j times the mean of the kernel phi(r - x) over the branch,
/// with the force f on b and the branch l from a to b. Its integral over the plane is 1 / t sum of
/// f l: area times the average stress (eq. 13). The kinetic part, of the order of the square of the
/// inertial number beside it, is not included.
///
/// Nothing is added for what lies outside of the sample: closer to its edge than the radius of the
/// kernel the stress falls, to about a half on the edge.
///
/// In a periodic cell the lines of the nearest images are there, for points and bodies within a
/// period of the cell and kernels with a radius below half a period.
/// @param thickness [m]
/// Throws InvalidInput unless thickness and radius are above 0 and all numbers finite.
[[nodiscard]] std::vector<Stress2> coarse_grained_stresses(std::span<const ForceLine> lines,
                                                           std::span<const Vec2> points,
                                                           const LucyKernel& kernel,
                                                           double thickness);

/// At the centroid of every particle, in the order of the bodies; zero for walls and platens.
template <class Contacts>
[[nodiscard]] std::vector<Stress2> coarse_grained_stresses(const Contacts& contacts,
                                                           const Particles& particles,
                                                           const LucyKernel& kernel) {
  std::vector<Vec2> points;
  for (const Body& body : particles.bodies()) points.push_back(body.position);
  std::vector<Stress2> out =
      coarse_grained_stresses(force_lines(contacts), points, kernel, particles.thickness());
  for (BodyIndex i = 0; i < particles.size(); ++i)
    if (particles.body(i).is_wall()) out[i] = {};
  return out;
}

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/measurement/coarse_grained_stress.ipp>
#endif
