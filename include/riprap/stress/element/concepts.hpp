// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the finite element.

#include <Eigen/Core>
#include <array>
#include <concepts>
#include <cstddef>
#include <type_traits>

#include <riprap/core/policy.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/stress/element/triangle_point.hpp>

namespace riprap {

/// Strain (e11, e22, 2 e12), tension positive, from the nodal displacements (u1, v1, u2, ...).
template <std::size_t Nodes>
using StrainDisplacement = Eigen::Matrix<double, 3, static_cast<int>(2 * Nodes)>;

/// Integrals of products of the shape functions of two nodes [m^2].
template <std::size_t Nodes>
using NodalMass = Eigen::Matrix<double, static_cast<int>(Nodes), static_cast<int>(Nodes)>;

namespace requirements {

/// `E::nodes`: 3, the corners, or 6: then the middles of the sides 0-1, 1-2 and 2-0 follow.
template <class E>
concept ElementNodes =
    requires { requires std::bool_constant<E::nodes == 3 || E::nodes == 6>::value; };

/// `E::sampling_points`: where the stress is evaluated. A failed point counts as a failed element,
/// so that Rat is the failed share of an element only if the shares are equal.
template <class E>
concept ElementSampling = requires {
  requires std::bool_constant<is_triangle_rule(E::sampling_points) &&
                              has_equal_shares(E::sampling_points)>::value;
};

/// `E::integration_points`: by which the stiffness is integrated.
template <class E>
concept ElementIntegration =
    requires { requires std::bool_constant<is_triangle_rule(E::integration_points)>::value; };

/// `element.strain_displacement(corners, at)` -> StrainDisplacement<E::nodes> [1/m], corners
/// counter-clockwise, `at` in barycentric coordinates. That type and no other: an expression of
/// Eigen would hold dangling references. Nothing is said of matrices of unknown size.
template <class E>
concept ElementStrain =
    !ElementNodes<E> ||
    requires(const E& element, const std::array<Vec2, 3>& corners, const Barycentric& at) {
      {
        element.strain_displacement(corners, at)
      } -> std::same_as<StrainDisplacement<std::size_t{E::nodes}>>;
    };

/// `element.mass(corners)` -> NodalMass<E::nodes> [m^2], which spreads body forces over the nodes:
/// inertia balances the loads of a particle.
template <class E>
concept ElementMass =
    !ElementNodes<E> || requires(const E& element, const std::array<Vec2, 3>& corners) {
      { element.mass(corners) } -> std::same_as<NodalMass<std::size_t{E::nodes}>>;
    };

}  // namespace requirements

/// An `Element` is a triangle with straight sides and three or six nodes.
template <class E>
concept Element = Policy<E> && requirements::ElementNodes<E> && requirements::ElementSampling<E> &&
                  requirements::ElementIntegration<E> && requirements::ElementStrain<E> &&
                  requirements::ElementMass<E>;

template <class E>
consteval bool check_element() {
  using namespace requirements;
  check_policy<E>();
  static_assert(ElementNodes<E>,
                "riprap: an Element must have static constexpr std::size_t nodes, 3 or 6");
  static_assert(ElementSampling<E>,
                "riprap: an Element must have static constexpr std::array<TrianglePoint, N> "
                "sampling_points whose shares are equal and sum to 1");
  static_assert(ElementIntegration<E>,
                "riprap: an Element must have static constexpr std::array<TrianglePoint, N> "
                "integration_points whose shares sum to 1");
  static_assert(ElementStrain<E>,
                "riprap: an Element must have StrainDisplacement<nodes> "
                "strain_displacement(const std::array<Vec2, 3>&, const Barycentric&) const");
  static_assert(
      ElementMass<E>,
      "riprap: an Element must have NodalMass<nodes> mass(const std::array<Vec2, 3>&) const");
  return Element<E>;
}

}  // namespace riprap
