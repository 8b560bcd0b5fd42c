// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>

#include <riprap/core/units.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct Fairhurst {             // Griffith's parabola, stretched to a given compressive strength
  double compression = 300e6;  // [Pa]
  double tension = 12e6;       // [Pa], positive
  double major_stress_at_failure(double minor) const {
    const double stretch = std::sqrt(1 + compression / tension) - 1;  // 2 is Griffith's
    const double width = stretch * stretch * tension;
    return minor + width + 2 * std::sqrt(width * std::max(0.0, minor + tension));
  }
  double tensile_strength() const { return tension; }
  void validate() const {
    require_positive("Fairhurst.compression", compression);
    require_positive("Fairhurst.tension", tension);
  }
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon platen{{-0.02, 0}, {0.04, 0}, {0.04, 0.016}, {-0.02, 0.016}};
  const Assembly pressed{.particles = {{square},  // 1 mm deep in a platen on either side
                                       {platen.moved({}, {0, 0.0150}), Motion::prescribed},
                                       {platen.moved({}, {0, -0.0150}), Motion::prescribed}}};
  Simulation sim{Model{}.criterion(Fairhurst{.compression = 200_MPa, .tension = 8_MPa}), pressed,
                 Rock{}};
  for (int i = 0; i < 3; ++i) sim.step();
  return sim.breaks().size() == 1 ? 0 : 1;
}
