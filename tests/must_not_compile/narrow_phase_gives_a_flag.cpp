// SPDX-License-Identifier: BSL-1.0
// riprap: a NarrowPhase must have std::optional<ContactGeometry> operator()(Ring, Ring, Cache&)
// const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  struct Cache {};
  bool operator()(Ring, Ring, Cache&) const { return false; }
};

const auto model = Model{}.narrow_phase(Mine{});
