// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Which nodes stick to a platen with friction, and how far the others slip.

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include <riprap/core/errors.hpp>

namespace riprap {

/// The nodes on the platens, with everything else in the specimen eliminated; linear in the slip.
struct PlatenNodes {
  Eigen::VectorXd pressed;  ///< forces of the platen that press on the nodes, while none slips [N]
  Eigen::VectorXd held;     ///< lateral forces of the platen on the nodes, while none slips [N]
  Eigen::MatrixXd pressed_per_slip;  ///< columns: what unit slip of one node adds to them [N/m]
  Eigen::MatrixXd held_per_slip;     ///< symmetric, positive semidefinite [N/m]
};

namespace internal {

/// Least of (v K v / 2 + q v + sum of g_i |v_i|) over the slips v: the lateral forces q + K v then
/// stay within g, and oppose the slip with g where there is any. Node by node (Gauss-Seidel), which
/// converges for such a sum (Tseng 2001). Begins at `v`.
inline void slip_under_limits(const PlatenNodes& nodes, const Eigen::VectorXd& limits,
                              Eigen::VectorXd& v) {
  const double enough = 1e-13 * nodes.held.cwiseAbs().maxCoeff();
  for (int sweep = 0; sweep < 100'000; ++sweep) {
    double largest_change = 0;
    for (Eigen::Index i = 0; i < v.size(); ++i) {
      const double stiffness = nodes.held_per_slip(i, i);
      const double stuck = nodes.held[i] + nodes.held_per_slip.row(i).dot(v) - stiffness * v[i];
      const double beyond = std::max(0.0, std::abs(stuck) - limits[i]);
      const double slip = -std::copysign(beyond, stuck) / stiffness;
      largest_change = std::max(largest_change, stiffness * std::abs(slip - v[i]));
      v[i] = slip;
    }
    if (largest_change <= enough) return;
  }
  throw SimulationError("coulomb_slip: the slip of the nodes does not settle");
}

}  // namespace internal

/// Lateral slip of each node [m] under Coulomb's law: the lateral force is at most `friction` times
/// the one that presses, and opposes the slip with that much where there is any. A specimen that is
/// loaded in proportion keeps its sticking and its slipping nodes, and slips in proportion, so that
/// one solution stands for the whole path. Limits are taken from the last normal forces and found
/// anew until they stand still. Throws SimulationError where they do not, which a friction
/// coefficient of many times 1 may bring about.
/// @param friction finite, above 0
[[nodiscard]] inline Eigen::VectorXd coulomb_slip(const PlatenNodes& nodes, double friction) {
  require_positive("coulomb_slip: friction", friction);
  Eigen::VectorXd slip = Eigen::VectorXd::Zero(nodes.held.size());
  Eigen::VectorXd limits = friction * nodes.pressed.cwiseMax(0);
  for (int round = 0; round < 200; ++round) {
    internal::slip_under_limits(nodes, limits, slip);
    const Eigen::VectorXd next =
        friction * (nodes.pressed + nodes.pressed_per_slip * slip).cwiseMax(0);
    const double change = (next - limits).cwiseAbs().maxCoeff();
    limits = next;
    if (change <= 1e-12 * limits.maxCoeff()) return slip;
  }
  throw SimulationError("coulomb_slip: the limits of friction do not settle");
}

}  // namespace riprap
