// SPDX-License-Identifier: BSL-1.0
// riprap: an Element must have StrainDisplacement strain_displacement(const std::array<Vec2, 3>&)
// const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  Eigen::Matrix3d mass(const std::array<Vec2, 3>&) const { return Eigen::Matrix3d::Identity(); }
};

const auto model = Model{}.element(Mine{});
