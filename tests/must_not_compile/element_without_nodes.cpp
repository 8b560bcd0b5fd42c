// SPDX-License-Identifier: BSL-1.0
// riprap: an Element must have static constexpr std::size_t nodes, 3 or 6
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine : ConstantStrainTriangle {
  static constexpr std::size_t nodes = 10;
};

const auto model = Model{}.element(Mine{});
