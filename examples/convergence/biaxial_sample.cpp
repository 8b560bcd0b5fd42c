// SPDX-License-Identifier: BSL-1.0
#include <riprap/riprap.hpp>

#include "loaded_particle.hpp"

namespace convergence {

Sample loaded_particles(const Test& test) {
  using namespace riprap;
  Simulation sim{Model{}.narrow_phase(OverlapMoments{}).contact_law(EnergyConservingSpring{}),
                 random_assembly({.count = test.particles, .seed = test.seed}), Rock{}};
  sim.set_breakage(test.breakage);
  BiaxialTest{.confining_pressure = test.pressure, .axial_strain = test.strain}.run(sim);

  const Particles& particles = sim.particles();
  Sample sample{.thickness = particles.thickness(), .mean_area = sim.mean_area()};
  for (BodyIndex i = 0; i < particles.size(); ++i) {
    if (!particles.body(i).is_free()) continue;
    if (test.breakage && particles.ancestry(i).generation == 0) continue;
    LoadedParticle particle;
    for (const ContactLoad& load : loads_on(sim.contacts(), i))
      if (load.force_lab != Vec2{0, 0}) particle.forces.push_back({load.arm_lab, load.force_lab});
    if (particle.forces.size() < 3) continue;
    for (const Vec2& x : particles.ring(i)) particle.ring.push_back(x - particles.body(i).position);
    sample.particles.push_back(particle);
  }
  return sample;
}

}  // namespace convergence
