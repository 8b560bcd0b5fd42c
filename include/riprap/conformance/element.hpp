// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the finite element.

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <utility>

#include <riprap/conformance/violations.hpp>
#include <riprap/core/random.hpp>
#include <riprap/stress/element/concepts.hpp>

namespace riprap {

namespace internal {

/// Corners, then the middles of the sides.
template <std::size_t Nodes>
[[nodiscard]] std::array<Vec2, Nodes> element_nodes(const std::array<Vec2, 3>& corners) {
  std::array<Vec2, Nodes> nodes;
  for (std::size_t k = 0; k < Nodes; ++k)
    nodes[k] = k < 3 ? corners[k] : Vec2(0.5 * (corners[k - 3] + corners[(k - 2) % 3]));
  return nodes;
}

// Displacements of 1e-3 of the size and strains of 1e-3: a rigid motion and a uniform strain.
template <Element E>
void check_strains(const E& element, const std::array<Vec2, 3>& corners, double size,
                   Random& random, AxiomCheck& check) {
  const auto number = [&random] { return random.uniform(-1, 1); };
  const auto nodes = element_nodes<E::nodes>(corners);
  const Vec2 shift = 1e-3 * size * Vec2{number(), number()};
  const Eigen::Matrix2d none = Eigen::Matrix2d::Zero();
  Eigen::Matrix2d turn;
  turn << 0, -1e-3, 1e-3, 0;
  Eigen::Matrix2d stretch;
  stretch << number(), number(), number(), number();
  stretch *= 1e-3;
  const Eigen::Vector3d expected{stretch(0, 0), stretch(1, 1), stretch(0, 1) + stretch(1, 0)};
  const auto check_at = [&](const TrianglePoint& point) {
    const StrainDisplacement<E::nodes> b = element.strain_displacement(corners, point.at);
    const auto strain = [&](const Vec2& by, const Eigen::Matrix2d& gradient) {
      Eigen::Vector3d sum{0, 0, 0};
      for (std::size_t k = 0; k < E::nodes; ++k)
        sum +=
            b.template middleCols<2>(2 * static_cast<Eigen::Index>(k)) * (by + gradient * nodes[k]);
      return sum;
    };
    check.equal("a shift causes no strain", strain(shift, none).norm(), 0, 1e-14);
    check.equal("a small turn causes no strain", strain({0, 0}, turn).norm(), 0, 1e-14);
    check.equal("linear displacements have their uniform strain",
                (strain(shift, stretch) - expected).norm(), 0, 1e-14);
  };
  for (const TrianglePoint& point : E::sampling_points) check_at(point);
  for (const TrianglePoint& point : E::integration_points) check_at(point);
}

// All but the three rigid motions cost energy: of the sum of B^T B all other eigenvalues are above
// 0. In slender triangles they differ by a few powers of ten.
template <Element E>
void check_stiffness(const E& element, const std::array<Vec2, 3>& corners, AxiomCheck& check) {
  constexpr auto size = static_cast<int>(2 * E::nodes);
  Eigen::Matrix<double, size, size> sum = Eigen::Matrix<double, size, size>::Zero();
  for (const TrianglePoint& point : E::integration_points) {
    const StrainDisplacement<E::nodes> b = element.strain_displacement(corners, point.at);
    sum += point.share * b.transpose() * b;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, size, size>> modes(sum);
  check.at_least("only rigid motions cost no energy: smallest eigenvalue but three",
                 modes.eigenvalues()[3] / modes.eigenvalues()[size - 1], 1e-7);
}

template <Element E>
void check_mass(const E& element, const std::array<Vec2, 3>& corners, double area,
                AxiomCheck& check) {
  const NodalMass<E::nodes> mass = element.mass(corners);
  const auto nodes = element_nodes<E::nodes>(corners);
  const Vec2 centroid = (corners[0] + corners[1] + corners[2]) / 3;
  const double round_off = 1e-12 * area;
  check.equal("the mass matrix is symmetric", (mass - mass.transpose()).norm(), 0, round_off);
  check.equal("the mass matrix sums to the area", mass.sum(), area, round_off);
  Vec2 moment{0, 0};
  double lever = 0;
  for (std::size_t k = 0; k < E::nodes; ++k) {
    const Vec2 arm = nodes[k] - centroid;
    moment += mass.row(static_cast<Eigen::Index>(k)).sum() * arm;
    lever = std::max(lever, arm.norm());
  }
  check.equal("a uniform load acts at the centroid", moment.norm(), 0, round_off * lever);
  check.at_least("the mass matrix is positive definite: smallest eigenvalue",
                 Eigen::SelfAdjointEigenSolver<NodalMass<E::nodes>>(mass).eigenvalues()[0] / area,
                 1e-6);
}

}  // namespace internal

/// Which axioms an element breaks, for random triangles of about `size` [m], at all of its points.
template <Element E>
[[nodiscard]] Violations element_violations(const E& element, double size = 1e-3) {
  AxiomCheck check;
  Random random(1);
  const auto number = [&random] { return random.uniform(-1, 1); };
  for (int i = 0; i < 200; ++i) {
    std::array<Vec2, 3> corners;
    for (Vec2& corner : corners) corner = size * Vec2{5 + number(), number()};
    double area = 0.5 * cross(corners[1] - corners[0], corners[2] - corners[0]);
    if (std::abs(area) < 0.05 * size * size) continue;
    if (area < 0) std::swap(corners[1], corners[2]);
    area = std::abs(area);
    internal::check_strains(element, corners, size, random, check);
    internal::check_stiffness(element, corners, check);
    internal::check_mass(element, corners, area, check);
  }
  return std::move(check).violations();
}

}  // namespace riprap
