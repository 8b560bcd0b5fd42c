#pragma once
/// @file
/// The role of the plane state: what the third direction does.

#include <Eigen/Core>
#include <concepts>

#include <riprap/core/stress2.hpp>
#include <riprap/material/rock.hpp>

namespace riprap {

/// A `PlaneState` gives the elasticity matrix of the plane.
///
/// - `plane.elasticity(rock)` -> 3x3 matrix [Pa] from strain (e11, e22, 2 e12) to stress
/// - `plane.out_of_plane_stress(rock, stress)` [Pa], with the sign of `stress`
template <class P>
concept PlaneState = requires(const P& plane, const Rock& rock, const Stress2& stress) {
  { plane.elasticity(rock) } -> std::same_as<Eigen::Matrix3d>;
  { plane.out_of_plane_stress(rock, stress) } -> std::convertible_to<double>;
};

}  // namespace riprap
