// SPDX-License-Identifier: BSL-1.0
// riprap: an Integrator must have void second_kick(Body&, const Wrench&, double time_step) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  static constexpr int order = 1;
  static constexpr bool has_second_kick = true;
  void advance(Body& body, const Wrench&, double time_step) const { drift(body, time_step); }
};

const auto model = Model{}.integrator(Mine{});
