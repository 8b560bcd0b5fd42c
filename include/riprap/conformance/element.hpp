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

/// Which axioms an element breaks, for random triangles of about `size` [m].
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

    // Displacements of 1e-3 of the size and strains of 1e-3: a rigid motion and a uniform strain.
    const StrainDisplacement b = element.strain_displacement(corners);
    const auto strain = [&](const Vec2& shift, const Eigen::Matrix2d& gradient) {
      Eigen::Matrix<double, 6, 1> nodal;
      for (int k = 0; k < 3; ++k)
        nodal.segment<2>(2 * k) = shift + gradient * corners[static_cast<std::size_t>(k)];
      return Eigen::Vector3d(b * nodal);
    };
    const Vec2 shift = 1e-3 * size * Vec2{number(), number()};
    const Eigen::Matrix2d none = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d turn;
    turn << 0, -1e-3, 1e-3, 0;
    Eigen::Matrix2d stretch;
    stretch << number(), number(), number(), number();
    stretch *= 1e-3;
    const Eigen::Vector3d expected{stretch(0, 0), stretch(1, 1), stretch(0, 1) + stretch(1, 0)};
    check.equal("a shift causes no strain", strain(shift, none).norm(), 0, 1e-14);
    check.equal("a small turn causes no strain", strain({0, 0}, turn).norm(), 0, 1e-14);
    check.equal("linear displacements have their uniform strain",
                (strain(shift, stretch) - expected).norm(), 0, 1e-14);

    const Eigen::Matrix3d mass = element.mass(corners);
    const double round_off = 1e-12 * area;
    check.equal("the mass matrix is symmetric", (mass - mass.transpose()).norm(), 0, round_off);
    check.equal("the mass matrix sums to the area", mass.sum(), area, round_off);
    for (int k = 0; k < 3; ++k)
      check.equal("every node carries a third of a uniform load", mass.row(k).sum(), area / 3,
                  round_off);
    check.at_least("the mass matrix is positive definite: smallest eigenvalue",
                   Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(mass).eigenvalues()[0] / area,
                   1e-6);
  }
  return std::move(check).violations();
}

}  // namespace riprap
