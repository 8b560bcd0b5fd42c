// SPDX-License-Identifier: BSL-1.0
// riprap: a BodyForce must have Vec2 operator()(const Body&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  double operator()(const Body&) const { return -9.81; }
};

const auto model = Model{}.body_force(Mine{});
