// SPDX-License-Identifier: BSL-1.0
// riprap: a Damping must have Wrench operator()(const Body&, const Wrench&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  Wrench operator()(Body& body, const Wrench&) const { return {-body.velocity, 0}; }
};

const auto model = Model{}.damping(Mine{});
