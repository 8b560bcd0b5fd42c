// SPDX-License-Identifier: BSL-1.0
// riprap: a NeighbourList must have static constexpr bool uses_skin
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  template <class Domain>
  using State = RebuildEveryStep::State<Domain>;
};

const auto model = Model{}.neighbour_list(Mine{});
