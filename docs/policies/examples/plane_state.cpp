// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/trigger/never_breaks.hpp>
#include <riprap/simulation/simulation.hpp>
using namespace riprap;

struct BeddedRock {    // plane stress, softer across the bedding: axis 2 of the body's own frame
  double ratio = 0.5;  // Young's modulus across over along the bedding [-]
  Eigen::Matrix3d elasticity(const Rock& rock) const {
    const double along = rock.young;
    const double across = ratio * along;
    const double nu = rock.poisson;
    const double f = 1 / (1 - nu * nu * ratio);
    const double shear = along * across / (along + across + 2 * nu * across);  // Saint-Venant
    Eigen::Matrix3d d;
    d << f * along, f * nu * across, 0, f * nu * across, f * across, 0, 0, 0, shear;
    return d;
  }
  double out_of_plane_stress(const Rock&, const Stress2&) const { return 0; }
};

int main() {
  const ConvexPolygon square{{0, 0}, {0.016, 0}, {0.016, 0.016}, {0, 0.016}};
  const ConvexPolygon platen{{-0.02, 0}, {0.04, 0}, {0.04, 0.016}, {-0.02, 0.016}};
  const Assembly pressed{.particles = {{square},  // 1 mm deep in a platen on either side
                                       {platen.moved({}, {0, 0.0150}), Motion::prescribed},
                                       {platen.moved({}, {0, -0.0150}), Motion::prescribed}}};
  Simulation sim{Model{}.plane_state(BeddedRock{}).trigger(NeverBreaks{}), pressed, Rock{}};
  for (int i = 0; i < 3; ++i) sim.step();
  return sim.failed_ratios()[0] > 0 ? 0 : 1;
}
