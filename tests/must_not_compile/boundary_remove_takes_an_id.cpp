// SPDX-License-Identifier: BSL-1.0
// riprap: remove of a Boundary must take a BodyIndex
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  void drive(std::vector<Body>&, double) {}
  void remove(const Body&) {}
};

const auto model = Model{}.boundary(Mine{});
