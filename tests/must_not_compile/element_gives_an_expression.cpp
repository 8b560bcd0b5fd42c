// SPDX-License-Identifier: BSL-1.0
// riprap: an Element must have NodalMass<nodes> mass(const std::array<Vec2, 3>&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine : ConstantStrainTriangle {
  auto mass(const std::array<Vec2, 3>&) const { return 2 * NodalMass<3>::Identity(); }
};

const auto model = Model{}.element(Mine{});
