#include <algorithm>
#include <cmath>

#include <riprap/core/units.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct Griffith {         // (sigma_1 - sigma_3)^2 = 8 T (sigma_1 + sigma_3)
  double tension = 12e6;  // T [Pa], positive
  double major_stress_at_failure(double minor) const {
    return minor + 4 * tension * (1 + std::sqrt(std::max(0.0, 1 + minor / tension)));
  }
  double tensile_strength() const { return tension; }
  void validate() const { require_positive("Griffith.tension", tension); }
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon platen{{-0.02, 0}, {0.04, 0}, {0.04, 0.016}, {-0.02, 0.016}};
  const Assembly pressed{.particles = {{square},  // 1 mm deep in a platen on either side
                                       {platen.moved({}, {0, 0.0150}), Motion::prescribed},
                                       {platen.moved({}, {0, -0.0150}), Motion::prescribed}}};
  Simulation sim{Model{}.criterion(Griffith{.tension = 8_MPa}), pressed, Rock{}};
  for (int i = 0; i < 3; ++i) sim.step();
  return sim.breaks().size() == 1 ? 0 : 1;
}
