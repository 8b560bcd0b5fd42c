// SPDX-License-Identifier: BSL-1.0
// riprap: validate() of a policy must be const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  double rate = 1;
  Wrench operator()(const Body& body, const Wrench&) const { return {-rate * body.velocity, 0}; }
  void validate() { require_positive("Mine.rate", rate); }
};

const auto model = Model{}.damping(Mine{});
