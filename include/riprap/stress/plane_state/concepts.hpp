// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the plane state: what the third direction does.

#include <Eigen/Core>
#include <algorithm>
#include <concepts>

#include <riprap/core/policy.hpp>
#include <riprap/core/stress2.hpp>
#include <riprap/material/rock.hpp>

namespace riprap {

namespace requirements {

/// `plane.elasticity(rock)` -> 3x3 matrix [Pa] from strain (e11, e22, 2 e12) to stress. That type
/// and no other: an expression of Eigen would hold dangling references.
template <class P>
concept PlaneStateElasticity = requires(const P& plane, const Rock& rock) {
  { plane.elasticity(rock) } -> std::same_as<Eigen::Matrix3d>;
};

/// `plane.out_of_plane_stress(rock, stress)` [Pa], with the sign of `stress`: only the state knows
/// the third normal stress.
template <class P>
concept PlaneStateStress = requires(const P& plane, const Rock& rock, const Stress2& stress) {
  { plane.out_of_plane_stress(rock, stress) } -> std::convertible_to<double>;
};

}  // namespace requirements

/// A `PlaneState` gives the elasticity matrix of the plane.
template <class P>
concept PlaneState =
    Policy<P> && requirements::PlaneStateElasticity<P> && requirements::PlaneStateStress<P>;

namespace internal {

/// factor * [normal, cross, 0; cross, normal, 0; 0, 0, shear]
[[nodiscard]] inline Eigen::Matrix3d elasticity_matrix(double factor, double normal, double cross,
                                                       double shear) {
  Eigen::Matrix3d d;
  std::fill_n(d.data(), 9, factor * 0);
  d(0, 0) = d(1, 1) = factor * normal;
  d(0, 1) = d(1, 0) = factor * cross;
  d(2, 2) = factor * shear;
  return d;
}

}  // namespace internal

template <class P>
consteval bool check_plane_state() {
  check_policy<P>();
  static_assert(requirements::PlaneStateElasticity<P>,
                "riprap: a PlaneState must have Eigen::Matrix3d elasticity(const Rock&) const");
  static_assert(requirements::PlaneStateStress<P>,
                "riprap: a PlaneState must have double out_of_plane_stress(const Rock&, const "
                "Stress2&) const");
  return PlaneState<P>;
}

}  // namespace riprap
