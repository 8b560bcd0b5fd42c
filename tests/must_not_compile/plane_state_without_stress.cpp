// SPDX-License-Identifier: BSL-1.0
// riprap: a PlaneState must have double out_of_plane_stress(const Rock&, const Stress2&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  Eigen::Matrix3d elasticity(const Rock&) const { return Eigen::Matrix3d::Identity(); }
};

const auto model = Model{}.plane_state(Mine{});
