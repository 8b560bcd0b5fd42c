// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Plane stress: free faces. The default, for particles about as thick as they are wide.

#include <riprap/stress/plane_state/concepts.hpp>

namespace riprap {

/// Nothing holds the faces: the out-of-plane stress is zero.
struct PlaneStress {
  [[nodiscard]] Eigen::Matrix3d elasticity(const Rock& rock) const {
    const double nu = rock.poisson;
    return internal::elasticity_matrix(rock.young / (1 - nu * nu), 1, nu, 0.5 * (1 - nu));
  }
  [[nodiscard]] double out_of_plane_stress(const Rock&, const Stress2&) const { return 0; }
};

static_assert(PlaneState<PlaneStress>);

}  // namespace riprap
