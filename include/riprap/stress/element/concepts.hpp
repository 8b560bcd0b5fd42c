#pragma once
/// @file
/// The role of the finite element.

#include <Eigen/Core>
#include <array>
#include <concepts>

#include <riprap/core/vec2.hpp>

namespace riprap {

/// Strain (e11, e22, 2 e12), tension positive, from the six nodal displacements (u1, v1, u2, ...).
using StrainDisplacement = Eigen::Matrix<double, 3, 6>;

/// An `Element` is a triangle with three nodes and one strain.
///
/// - `element.strain_displacement(corners)` -> StrainDisplacement [1/m], corners counter-clockwise
/// - `element.mass(corners)` -> 3x3 matrix [m^2]: integrals of products of shape functions, which
///   spread body forces over the nodes
template <class E>
concept Element = requires(const E& element, const std::array<Vec2, 3>& corners) {
  { element.strain_displacement(corners) } -> std::same_as<StrainDisplacement>;
  { element.mass(corners) } -> std::same_as<Eigen::Matrix3d>;
};

}  // namespace riprap
