// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Matrices of all elements of a mesh, for code that does not depend on the type of the element.

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <riprap/stress/element/concepts.hpp>
#include <riprap/stress/mesher/mesh.hpp>

namespace riprap {

/// By columns, one matrix after the other.
struct ElementMatrices {
  std::size_t nodes = 0;             ///< of an element
  std::vector<double> shares{};      ///< of the integration points
  std::vector<double> sampled{};     ///< strain-displacement at each sampling point of each element
  std::vector<double> integrated{};  ///< and at each of its integration points
  std::vector<double> mass{};        ///< of each element

  /// At sampling point i of all.
  [[nodiscard]] const double* sampled_strain(std::size_t i) const {
    return sampled.data() + 6 * nodes * i;
  }
  /// At integration point i of element e.
  [[nodiscard]] const double* strain_to_integrate(std::size_t e, std::size_t i) const {
    return integrated.data() + 6 * nodes * (shares.size() * e + i);
  }
  [[nodiscard]] const double* mass_of(std::size_t e) const {
    return mass.data() + nodes * nodes * e;
  }
};

/// @param mesh with the nodes of the element
template <Element E>
[[nodiscard]] ElementMatrices element_matrices(const Mesh& mesh, const E& element) {
  constexpr std::size_t strain_size = 6 * E::nodes;
  constexpr std::size_t mass_size = E::nodes * E::nodes;
  ElementMatrices all{.nodes = E::nodes};
  for (const TrianglePoint& point : E::integration_points) all.shares.push_back(point.share);
  all.sampled.resize(mesh.size() * E::sampling_points.size() * strain_size);
  all.integrated.resize(mesh.size() * E::integration_points.size() * strain_size);
  all.mass.resize(mesh.size() * mass_size);
  auto sampled = all.sampled.begin();
  auto integrated = all.integrated.begin();
  auto mass = all.mass.begin();
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    const std::array<Vec2, 3> corners = mesh.triangle(e);
    const auto append_strains = [&](const auto& points, auto& to) {
      for (const TrianglePoint& point : points) {
        const auto strain = element.strain_displacement(corners, point.at);
        to = std::copy_n(strain.data(), strain_size, to);
      }
    };
    append_strains(E::sampling_points, sampled);
    append_strains(E::integration_points, integrated);
    mass = std::copy_n(element.mass(corners).data(), mass_size, mass);
  }
  return all;
}

}  // namespace riprap
