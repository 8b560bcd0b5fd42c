// SPDX-License-Identifier: BSL-1.0
// riprap: a Boundary must have void drive(std::vector<Body>&, double)
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  void drive(Body& body, double) { body.velocity = {0, 0}; }
};

const auto model = Model{}.boundary(Mine{});
