// SPDX-License-Identifier: BSL-1.0
// riprap: an Element must have StrainDisplacement<nodes> strain_displacement(const std::array<Vec2,
// 3>&, const Barycentric&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  static constexpr std::size_t nodes = 3;
  static constexpr auto sampling_points = centroid_rule;
  static constexpr auto integration_points = centroid_rule;
  NodalMass<3> mass(const std::array<Vec2, 3>&) const { return NodalMass<3>::Identity(); }
};

const auto model = Model{}.element(Mine{});
