// SPDX-License-Identifier: BSL-1.0
// riprap: a NarrowPhase must have std::optional<ContactGeometry> operator()(Ring, Ring, Memory&)
// const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  struct Memory {};
  bool operator()(Ring, Ring, Memory&) const { return false; }
};

const auto model = Model{}.narrow_phase(Mine{});
