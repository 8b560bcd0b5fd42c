// SPDX-License-Identifier: BSL-1.0
// riprap: an Element must have Eigen::Matrix3d mass(const std::array<Vec2, 3>&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine : ConstantStrainTriangle {
  auto mass(const std::array<Vec2, 3>&) const { return 2 * Eigen::Matrix3d::Identity(); }
};

const auto model = Model{}.element(Mine{});
