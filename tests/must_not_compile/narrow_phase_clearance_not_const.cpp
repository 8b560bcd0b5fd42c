// SPDX-License-Identifier: BSL-1.0
// riprap: clearance of a NarrowPhase must be double clearance(const Memory&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  struct Memory {
    double gap = 0;
  };
  std::optional<ContactGeometry> operator()(Ring, Ring, Memory&) const { return std::nullopt; }
  double clearance(const Memory& memory) { return memory.gap; }
};

const auto model = Model{}.narrow_phase(Mine{});
