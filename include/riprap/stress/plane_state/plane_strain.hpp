// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Plane strain: nothing moves out of the plane.

#include <riprap/stress/plane_state/concepts.hpp>

namespace riprap {

/// The out-of-plane strain is zero; the stress that holds it is nu (s11 + s22).
struct PlaneStrain {
  [[nodiscard]] Eigen::Matrix3d elasticity(const Rock& rock) const {
    const double nu = rock.poisson;
    return internal::elasticity_matrix(rock.young / ((1 + nu) * (1 - 2 * nu)), 1 - nu, nu,
                                       0.5 - nu);
  }
  [[nodiscard]] double out_of_plane_stress(const Rock& rock, const Stress2& stress) const {
    return rock.poisson * (stress.s11 + stress.s22);
  }
};

static_assert(PlaneState<PlaneStrain>);

}  // namespace riprap
