// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The mean diameter of the particles that a sample was made of.

#include <algorithm>
#include <vector>

#include <riprap/core/ids.hpp>
#include <riprap/geometry/polygon_properties.hpp>
#include <riprap/measurement/energy.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Of the circle of the mean area of the intact particles [m], platens and prescribed bodies left
/// out: that of `sim.mean_area()`. With bonds a cluster of cells is one particle, and its pieces
/// and its dust are parts of it.
template <class Sim>
[[nodiscard]] double mean_particle_diameter(const Sim& sim) {
  if constexpr (has_bonds<Sim>) {
    const Particles& particles = sim.particles();
    double area = particles.dust_area();
    std::vector<ParticleId> roots;
    for (BodyIndex i = 0; i < particles.size(); ++i) {
      const Body& body = particles.body(i);
      if (body.is_wall() || body.motion == Motion::prescribed) continue;
      area += particles.shape(i).area;
      roots.push_back(particles.ancestry(i).root);
    }
    std::sort(roots.begin(), roots.end());
    const auto count = std::unique(roots.begin(), roots.end()) - roots.begin();
    if (count > 0) return equivalent_diameter(area / static_cast<double>(count));
  }
  return equivalent_diameter(sim.mean_area());
}

}  // namespace riprap
