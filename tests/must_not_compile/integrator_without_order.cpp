// SPDX-License-Identifier: BSL-1.0
// riprap: an Integrator must have static constexpr int order
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  static constexpr bool has_second_kick = false;
  void advance(Body& body, const Wrench&, double time_step) const { drift(body, time_step); }
  void second_kick(Body&, const Wrench&, double) const {}
};

const auto model = Model{}.integrator(Mine{});
