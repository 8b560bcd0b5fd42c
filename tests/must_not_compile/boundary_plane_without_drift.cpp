// SPDX-License-Identifier: BSL-1.0
// riprap: a Boundary with a plane() must have PeriodicPlane plane() const and void drift(double)
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  void drive(std::vector<Body>&, double) {}
  PeriodicPlane plane() const { return {}; }
};

const auto model = Model{}.boundary(Mine{});
