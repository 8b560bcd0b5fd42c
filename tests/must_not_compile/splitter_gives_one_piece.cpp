// SPDX-License-Identifier: BSL-1.0
// riprap: a Splitter must have std::optional<CutRings> operator()(Ring, const Line&, double
// mean_area) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  std::vector<Vec2> operator()(Ring ring, const Line&, double) const {
    return {ring.begin(), ring.end()};
  }
};

const auto model = Model{}.splitter(Mine{});
