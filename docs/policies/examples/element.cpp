// SPDX-License-Identifier: BSL-1.0
#include <array>

#include <riprap/breakage/trigger/never_breaks.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct LumpedTriangle : ConstantStrainTriangle {  // a third of the mass at each corner
  NodalMass<3> mass(const std::array<Vec2, 3>& corners) const {
    const double area = 0.5 * cross(corners[1] - corners[0], corners[2] - corners[0]);
    return area / 3 * NodalMass<3>::Identity();
  }
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon platen{{-0.02, 0}, {0.04, 0}, {0.04, 0.016}, {-0.02, 0.016}};
  const Assembly pressed{.particles = {{square},  // 1 mm deep in a platen on either side
                                       {platen.moved({}, {0, 0.0150}), Motion::prescribed},
                                       {platen.moved({}, {0, -0.0150}), Motion::prescribed}}};
  Simulation sim{Model{}.element(LumpedTriangle{}).trigger(NeverBreaks{}), pressed, Rock{}};
  for (int i = 0; i < 3; ++i) sim.step();
  return sim.failed_ratios()[0] > 0 ? 0 : 1;
}
