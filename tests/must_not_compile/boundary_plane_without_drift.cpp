// SPDX-License-Identifier: BSL-1.0
// riprap: a Boundary with a domain() must have PeriodicDomain domain() const and void drift(double)
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  void drive(std::vector<Body>&, double) {}
  PeriodicDomain domain() const { return {}; }
};

const auto model = Model{}.boundary(Mine{});
