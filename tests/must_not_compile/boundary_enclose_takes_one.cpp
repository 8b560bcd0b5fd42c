// SPDX-License-Identifier: BSL-1.0
// riprap: enclose of a Boundary must take (const Assembly&, const Particles&)
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  void drive(std::vector<Body>&, double) {}
  void enclose(const Assembly&) {}
};

const auto model = Model{}.boundary(Mine{});
