// SPDX-License-Identifier: BSL-1.0
#include <array>
#include <cstdio>

#include <riprap/particle/share_materials.hpp>  // not part of riprap.hpp
#include <riprap/riprap.hpp>
using namespace riprap;

struct WeakerFriction {  // a mixing rule of one's own: that of the rock with the smaller friction
  template <ContactLaw Law>
  Law operator()(const Law& a, const Law& b, const MaterialPair& /*pair*/) const {
    return a.friction < b.friction ? a : b;
  }
};

int main() {
  const Rocks rocks{Rock{.young = 70.0_GPa, .density = 2700},   // material 0
                    Rock{.young = 20.0_GPa, .density = 2300}};  // material 1
  const CriterionOfRock strengths{{HoekBrown{.compressive_strength = 300.0_MPa, .m_b = 25},
                                   HoekBrown{.compressive_strength = 60.0_MPa, .m_b = 17}}};
  const std::vector<EnergyConservingSpring> springs{{.friction = 0.5}, {.friction = 0.4}};
  Assembly assembly = random_assembly({.count = 100, .seed = 1});
  share_materials(assembly, {0.7, 0.3});  // 30 % of the area is weak

  auto model = Model{}.criterion(strengths).contact_law(MixedContactLaw{springs, WeakerFriction{}});
  Simulation sim{model, assembly, rocks};
  Curve curve;
  BiaxialTest{.confining_pressure = 4.0_MPa, .axial_strain = 0.03}.run(sim, curve);

  std::array<int, 2> pieces{};
  for (BodyIndex i = 0; i < sim.particles().size(); ++i)
    if (sim.particles().ancestry(i).generation > 0) ++pieces[sim.particles().material(i)];
  std::printf("peak sin phi %.2f, %d strong and %d weak pieces\n", curve.peak().sin_phi(),
              pieces[0], pieces[1]);
  return pieces[1] > pieces[0] ? 0 : 1;  // of 30 % of the area come more pieces than of the rest
}
