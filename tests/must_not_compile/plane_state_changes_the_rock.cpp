// SPDX-License-Identifier: BSL-1.0
// riprap: a PlaneState must have Eigen::Matrix3d elasticity(const Rock&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  Eigen::Matrix3d elasticity(Rock& rock) const { return rock.young * Eigen::Matrix3d::Identity(); }
  double out_of_plane_stress(const Rock&, const Stress2&) const { return 0; }
};

const auto model = Model{}.plane_state(Mine{});
