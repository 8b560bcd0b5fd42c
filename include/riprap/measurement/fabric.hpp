// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Anisotropy of contact normals, contact forces and branch vectors: eqs 9 to 11 of the paper.

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <riprap/core/errors.hpp>
#include <riprap/core/linkage.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap {

/// The data of one contact for the statistics of fabric.
struct ContactSample {
  Vec2 normal{1, 0};            ///< from a to b
  double normal_force = 0;      ///< [N]
  double tangential_force = 0;  ///< on b, along the normal turned by +90 degrees [N]
  Vec2 branch{1, 0};            ///< from the centroid of a to that of b [m]
};

/// All contacts but those with walls and platens, whose directions are the walls'.
template <class Contacts>
[[nodiscard]] std::vector<ContactSample> contact_samples(const Contacts& contacts) {
  std::vector<ContactSample> samples;
  contacts.for_each_touching([&](const auto& c) {
    if (c.at_wall()) return;
    samples.push_back({c.geometry.normal, c.force.normal, c.force.tangential, c.branch()});
  });
  return samples;
}

/// Second-order Fourier coefficient of a distribution over directions and its major direction.
struct Anisotropy {
  double coefficient = 0;  ///< [-], >= 0
  double direction = 0;    ///< [rad], in (-pi/2, pi/2]

  /// The coefficient as seen from another direction: coefficient * cos 2(direction - axis).
  [[nodiscard]] double along(double axis) const {
    return coefficient * std::cos(2 * (direction - axis));
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("coefficient", self.coefficient);
    visit("direction", self.direction);
  }
};

/// The Fourier description of an assembly's contacts:
///   E(theta)   = 1/(2 pi) (1 + a cos 2(theta - theta_0))                        eq. 9
///   f_n(theta) = f_0 (1 + a_n cos 2(theta - theta_f))                           eq. 10
///   f_t(theta) = -f_0 a_t sin 2(theta - theta_t)                                eq. 11
/// and likewise for the branch vector's parts along and across the normal, with l_0, b_n, b_t.
struct Fabric {
  Anisotropy normals{};              ///< a, theta_0
  Anisotropy normal_forces{};        ///< a_n, theta_f
  Anisotropy tangential_forces{};    ///< a_t, theta_t
  Anisotropy normal_branches{};      ///< b_n
  Anisotropy tangential_branches{};  ///< b_t
  double mean_normal_force = 0;      ///< f_0 [N], mean over orientations, not over contacts
  double mean_branch = 0;            ///< l_0 [m], likewise
  /// Contacts left out of all but a: with a >= 1 the density of eq. 9 is not positive in their
  /// direction, so that no average over orientations has a weight for them.
  std::size_t left_out = 0;

  static void for_each_field(auto& self, auto&& visit) {
    visit("normals", self.normals);
    visit("normal_forces", self.normal_forces);
    visit("tangential_forces", self.tangential_forces);
    visit("normal_branches", self.normal_branches);
    visit("tangential_branches", self.tangential_branches);
    visit("mean_normal_force", self.mean_normal_force);
    visit("mean_branch", self.mean_branch);
    visit("left_out", self.left_out);
  }
};

namespace internal {

/// Symmetric traceless part (xx - yy) / 2 and xy of a second-order moment.
struct Deviator {
  double half_difference = 0;
  double shear = 0;
  void add(double weight, const Vec2& u, const Vec2& v) {
    half_difference += 0.5 * weight * (u.x() * v.x() - u.y() * v.y());
    shear += 0.5 * weight * (u.x() * v.y() + u.y() * v.x());
  }
  /// The moment of (1 + c cos 2(theta - theta_c)) n n has a deviator of radius c / 4.
  [[nodiscard]] Anisotropy anisotropy(double total) const {
    if (total == 0) return {};
    const double radius = std::hypot(half_difference, shear);
    return {4 * radius / total, radius == 0 ? 0 : 0.5 * std::atan2(shear, half_difference)};
  }
};

}  // namespace internal

/// Second-order moments give the coefficients, without bins. Forces and branches are averaged over
/// orientations: each contact is weighted by 1 / (1 + a cos 2(theta - theta_0)), for a plain
/// average over contacts biases a_n. Throws InvalidInput for a sample that is not finite.
[[nodiscard]] Fabric fabric(std::span<const ContactSample> samples);

}  // namespace riprap

#ifndef RIPRAP_COMPILED
#include <riprap/measurement/fabric.ipp>
#endif
