// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the finite element.

#include <Eigen/Core>
#include <array>
#include <concepts>

#include <riprap/core/policy.hpp>
#include <riprap/core/vec2.hpp>

namespace riprap {

/// Strain (e11, e22, 2 e12), tension positive, from the six nodal displacements (u1, v1, u2, ...).
using StrainDisplacement = Eigen::Matrix<double, 3, 6>;

namespace requirements {

/// `element.strain_displacement(corners)` -> StrainDisplacement [1/m], corners counter-clockwise.
/// That type and no other: an expression of Eigen would hold dangling references.
template <class E>
concept ElementStrain = requires(const E& element, const std::array<Vec2, 3>& corners) {
  { element.strain_displacement(corners) } -> std::same_as<StrainDisplacement>;
};

/// `element.mass(corners)` -> 3x3 matrix [m^2]: integrals of products of shape functions, which
/// spread body forces over the nodes: inertia balances the loads of a particle.
template <class E>
concept ElementMass = requires(const E& element, const std::array<Vec2, 3>& corners) {
  { element.mass(corners) } -> std::same_as<Eigen::Matrix3d>;
};

}  // namespace requirements

/// An `Element` is a triangle with three nodes and one strain.
template <class E>
concept Element = Policy<E> && requirements::ElementStrain<E> && requirements::ElementMass<E>;

template <class E>
consteval bool check_element() {
  check_policy<E>();
  static_assert(requirements::ElementStrain<E>,
                "riprap: an Element must have StrainDisplacement "
                "strain_displacement(const std::array<Vec2, 3>&) const");
  static_assert(
      requirements::ElementMass<E>,
      "riprap: an Element must have Eigen::Matrix3d mass(const std::array<Vec2, 3>&) const");
  return Element<E>;
}

}  // namespace riprap
