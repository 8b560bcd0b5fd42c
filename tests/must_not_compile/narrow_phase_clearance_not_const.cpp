// SPDX-License-Identifier: BSL-1.0
// riprap: clearance of a NarrowPhase must be double clearance(const Cache&) const
#include <riprap/simulation/model.hpp>
using namespace riprap;

struct Mine {
  struct Cache {
    double gap = 0;
  };
  std::optional<ContactGeometry> operator()(Ring, Ring, Cache&) const { return std::nullopt; }
  double clearance(const Cache& cache) { return cache.gap; }
};

const auto model = Model{}.narrow_phase(Mine{});
