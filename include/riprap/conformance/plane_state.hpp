// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The axioms of the plane state.

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <utility>

#include <riprap/conformance/violations.hpp>
#include <riprap/core/random.hpp>
#include <riprap/material/rock.hpp>
#include <riprap/stress/plane_state/concepts.hpp>

namespace riprap {
namespace internal {

[[nodiscard]] inline Stress2 random_stress(Random& random) {
  return {random.uniform(-1e8, 1e8), random.uniform(-1e8, 1e8), random.uniform(-1e8, 1e8)};
}

}  // namespace internal

/// Which axioms a plane state breaks, for rock with Poisson's ratios from 0 to 0.45.
template <PlaneState P>
[[nodiscard]] Violations plane_state_violations(const P& plane) {
  AxiomCheck check;
  Random random(1);
  for (const double poisson : {0.0, 0.17, 0.3, 0.45}) {
    const Rock rock{.poisson = poisson};
    check.at("Poisson's ratio", poisson);
    const Eigen::Matrix3d d = plane.elasticity(rock);
    check.equal("elasticity is symmetric", (d - d.transpose()).norm() / rock.young, 0, 1e-14);
    check.at_least("strain stores energy: smallest eigenvalue over Young's modulus",
                   Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(d).eigenvalues()[0] / rock.young,
                   1e-6);
    Rock stiffer = rock;
    stiffer.young *= 2;
    const Eigen::Matrix3d stiffened = plane.elasticity(stiffer);
    check.equal("elasticity is proportional to Young's modulus",
                (stiffened - 2 * d).norm() / rock.young, 0, 1e-12);
    for (int i = 0; i < 20; ++i) {
      const Stress2 stress = internal::random_stress(random);
      const double out = plane.out_of_plane_stress(rock, stress);
      check.equal("the out-of-plane stress is proportional to the stress in the plane",
                  plane.out_of_plane_stress(rock, -3 * stress), -3 * out, 1e-6);
    }
  }
  return std::move(check).violations();
}

/// For plane states of isotropic rock: strains in the plane are those of Hooke's law in three
/// dimensions, with the out-of-plane stress that the model gives.
template <PlaneState P>
[[nodiscard]] Violations plane_state_hooke_violations(const P& plane) {
  AxiomCheck check;
  Random random(1);
  for (const double nu : {0.0, 0.17, 0.3, 0.45}) {
    const Rock rock{.poisson = nu};
    check.at("Poisson's ratio", nu);
    for (int i = 0; i < 20; ++i) {
      const Stress2 s = internal::random_stress(random);
      const double out = plane.out_of_plane_stress(rock, s);
      const Eigen::Matrix3d d = plane.elasticity(rock);
      const Eigen::Vector3d strain = d.inverse() * Eigen::Vector3d{s.s11, s.s22, s.s12};
      const Eigen::Vector3d expected{s.s11 - nu * (s.s22 + out), s.s22 - nu * (s.s11 + out),
                                     2 * (1 + nu) * s.s12};
      // Strains of 1e-3; the inverse loses up to two digits next to incompressibility.
      check.equal("strains are those of Hooke's law: difference",
                  (strain - expected / rock.young).norm(), 0, 1e-15);
    }
  }
  return std::move(check).violations();
}

}  // namespace riprap
