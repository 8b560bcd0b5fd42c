// SPDX-License-Identifier: BSL-1.0
#pragma once
// How much of a sample is no longer where it was: pieces and dust.

#include <algorithm>
#include <map>

#include <riprap/particle/particles.hpp>

namespace shear_tests {

struct BrokenMass {
  double broken = 0;    // pieces and dust over all rock [-]
  double detached = 0;  // the same without the largest piece of each particle [-]
};

// Of the free particles; all rock has one density and thickness, so area stands for mass.
[[nodiscard]] inline BrokenMass broken_mass(const riprap::Particles& particles) {
  double all = particles.dust_area();
  double broken = particles.dust_area();
  double largest_ones = 0;
  std::map<riprap::ParticleId, double> largest;  // piece of each broken particle
  for (riprap::BodyIndex i = 0; i < particles.size(); ++i) {
    if (!particles.body(i).is_free()) continue;
    const double area = particles.shape(i).area;
    all += area;
    if (particles.ancestry(i).generation == 0) continue;
    broken += area;
    double& most = largest[particles.ancestry(i).root];
    most = std::max(most, area);
  }
  for (const auto& [root, area] : largest) largest_ones += area;
  return {broken / all, (broken - largest_ones) / all};
}

}  // namespace shear_tests
