// SPDX-License-Identifier: BSL-1.0
// riprap: is_dust of a Splitter must be bool is_dust(Ring, double mean_area) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine : StraightCut {
  bool is_dust(Ring piece, double mean_area) { return polygon_area(piece) < 0.01 * mean_area; }
};

const auto model = Model{}.splitter(Mine{});
