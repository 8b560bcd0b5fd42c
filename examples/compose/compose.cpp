// SPDX-License-Identifier: BSL-1.0
// compose: the whole simulator in 25 lines, with a failure criterion of your own
#include <riprap/riprap.hpp>
using namespace riprap;

struct TrescaWithTensionCutOff {  // no base class, no macro, no registration
  double strength = 300e6, tension = 12e6;  // [Pa], both positive
  double major_stress_at_failure(double minor) const { return minor + strength; }
  double tensile_strength() const { return tension; }
};

int main() {
  const Rock basalt{.young = 70.0_GPa, .poisson = 0.17, .density = 2500};
  auto model = Model{}
      .contact_law(EnergyConservingSpring{.normal_stiffness = 2e7, .tangential_stiffness = 2e7, .friction = 0.5})
      .criterion(TrescaWithTensionCutOff{.strength = 300.0_MPa, .tension = 12.0_MPa})
      .line_fit(WeightedXY{})
      .integrator(SymplecticEuler{});
  Simulation sim{model, random_assembly({.count = 500, .mean_diameter = 0.016, .thickness = 0.016, .seed = 1}), basalt};
  Curve curve;
  BiaxialTest{.confining_pressure = 2.0_MPa, .axial_strain = 0.20}.run(sim, curve, Progress{});
  write_csv("biaxial.csv", curve);
}
