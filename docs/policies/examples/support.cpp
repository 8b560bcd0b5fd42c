// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <span>

#include <riprap/breakage/trigger/never_breaks.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct StrongContactsOnly {  // weak contacts load nothing; inertia balances what is left
  double share = 0.2;        // of the largest normal force, below which a contact is weak [-]
  static constexpr bool needs_flexibility = false;
  void apply_reactions(std::span<BoundaryLoad> loads, const InfluenceOperator& /*op*/) const {
    double largest = 0;
    for (const BoundaryLoad& load : loads) largest = std::max(largest, load.normal_force);
    for (BoundaryLoad& load : loads)
      if (load.normal_force < share * largest) load.force_body = Vec2{0, 0};
  }
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon platen{{-0.02, 0}, {0.04, 0}, {0.04, 0.016}, {-0.02, 0.016}};
  const Assembly pressed{.particles = {{square},  // 1 mm deep in a platen on either side
                                       {platen.moved({}, {0, 0.0150}), Motion::prescribed},
                                       {platen.moved({}, {0, -0.0150}), Motion::prescribed}}};
  Simulation sim{Model{}.support(StrongContactsOnly{}).trigger(NeverBreaks{}), pressed, Rock{}};
  for (int i = 0; i < 3; ++i) sim.step();
  return sim.failed_ratios()[0] > 0 ? 0 : 1;
}
