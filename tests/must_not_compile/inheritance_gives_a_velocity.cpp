// SPDX-License-Identifier: BSL-1.0
// riprap: an Inheritance must have void operator()(const Body& parent, Body& piece) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  Vec2 operator()(const Body& parent) const { return parent.velocity; }
};

const auto model = Model{}.inheritance(Mine{});
