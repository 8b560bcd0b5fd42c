// SPDX-License-Identifier: BSL-1.0
// riprap: a Mesher must have Mesh operator()(Ring) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  std::vector<Vec2> operator()(Ring ring) const { return {ring.begin(), ring.end()}; }
};

const auto model = Model{}.mesher(Mine{});
