// SPDX-License-Identifier: BSL-1.0
#include "sample.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include <riprap/breakage/criterion/never_fails.hpp>
#include <riprap/experiment/loading_path.hpp>
#include <riprap/experiment/preparation.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/particle/random_assembly.hpp>
#include <riprap/simulation/simulation.hpp>

namespace rivals {

using namespace riprap;

Assembly compacted_sample(unsigned particles, std::uint64_t seed) {
  const Assembly loose = random_assembly({.count = particles, .seed = seed});
  Simulation sim{Model{}.criterion(NeverFails{}), loose, Rock{}};
  LoadingPath<>{.stages = {Preparation{}.compaction()}}.run(sim);
  Assembly sample = loose;
  sample.particles.clear();
  const Particles& all = sim.particles();
  for (BodyIndex i = 0; i < all.size(); ++i)
    sample.particles.push_back(
        {ConvexPolygon(std::vector<Vec2>(all.ring(i).begin(), all.ring(i).end())),
         all.body(i).motion});
  return sample;
}

double mean_diameter(const Assembly& sample) {
  double sum = 0;
  double count = 0;
  for (const PlacedParticle& particle : sample.particles) {
    if (particle.motion != Motion::free) continue;
    sum += 2 * std::sqrt(area_properties(particle.polygon).area / std::numbers::pi);
    ++count;
  }
  return sum / count;
}

}  // namespace rivals
