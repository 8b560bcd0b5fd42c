// SPDX-License-Identifier: BSL-1.0
#include <cstddef>

#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct FailedCount {  // breaks when so many elements have failed
  std::size_t critical = 20;
  bool operator()(const FailureCount& failures) const { return failures.failed >= critical; }
  std::size_t failed_elements_needed(std::size_t) const { return critical; }
  void validate() const {
    require(critical >= 1, "FailedCount.critical", double(critical), "must be 1 or more");
  }
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon platen{{-0.02, 0}, {0.04, 0}, {0.04, 0.016}, {-0.02, 0.016}};
  const Assembly pressed{.particles = {{square},  // 1 mm deep in a platen on either side
                                       {platen.moved({}, {0, 0.0150}), Motion::prescribed},
                                       {platen.moved({}, {0, -0.0150}), Motion::prescribed}}};
  Simulation sim{Model{}.trigger(FailedCount{.critical = 15}), pressed, Rock{}};
  for (int i = 0; i < 3; ++i) sim.step();
  return !sim.breaks().empty() && sim.breaks()[0].failures.failed >= 15 ? 0 : 1;
}
