// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Stiffness of one element and its stresses, for direct solvers.

#include <Eigen/Core>
#include <array>
#include <cstddef>

#include <riprap/stress/element/concepts.hpp>
#include <riprap/stress/element/element_stress.hpp>
#include <riprap/stress/mesher/mesh.hpp>

namespace riprap {

/// Number of displacements of an element.
template <Element E>
inline constexpr std::size_t element_unknowns = 2 * E::nodes;

/// Places of the displacements of triangle e among those of all nodes: u1, u2 of node 0, of node 1.
template <Element E>
[[nodiscard]] std::array<Eigen::Index, element_unknowns<E>> degrees_of_freedom(const Mesh& mesh,
                                                                               std::size_t e) {
  std::array<Eigen::Index, element_unknowns<E>> dof{};
  for (std::size_t k = 0; k < dof.size(); ++k)
    dof[k] = 2 * static_cast<Eigen::Index>(mesh.node(e, k / 2)) + static_cast<Eigen::Index>(k % 2);
  return dof;
}

template <Element E>
using ElementStiffness = Eigen::Matrix<double, static_cast<int>(element_unknowns<E>),
                                       static_cast<int>(element_unknowns<E>)>;

/// Of triangle e [N/m].
template <Element E>
[[nodiscard]] ElementStiffness<E>
element_stiffness(const E& element, const Mesh& mesh, std::size_t e,
                  const Eigen::Matrix3d& elasticity, double thickness) {
  const double volume = thickness * mesh.area(e);
  ElementStiffness<E> sum = ElementStiffness<E>::Zero();
  for (const TrianglePoint& point : E::integration_points) {
    const auto b = element.strain_displacement(mesh.triangle(e), point.at);
    sum += (point.share * volume) * (b.transpose() * elasticity * b);
  }
  return sum;
}

/// Stresses, compression positive, at the sampling points of all triangles.
/// @param displacements u1, u2 of node 0, of node 1, ... [m]
template <Element E>
void find_element_stress(const E& element, const Mesh& mesh, const Eigen::Matrix3d& elasticity,
                         const Eigen::VectorXd& displacements, ElementStress& stress) {
  stress.reset(mesh.size() * E::sampling_points.size());
  std::size_t i = 0;
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    Eigen::Matrix<double, static_cast<int>(element_unknowns<E>), 1> nodal;
    const auto dof = degrees_of_freedom<E>(mesh, e);
    for (std::size_t k = 0; k < dof.size(); ++k)
      nodal[static_cast<Eigen::Index>(k)] = displacements[dof[k]];
    for (const TrianglePoint& point : E::sampling_points) {
      const Eigen::Vector3d tension =
          elasticity * (element.strain_displacement(mesh.triangle(e), point.at) * nodal);
      stress.set(i++, {-tension[0], -tension[1], -tension[2]});
    }
  }
}

}  // namespace riprap
