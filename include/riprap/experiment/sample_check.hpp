// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Whether a sample is still one.

#include <cmath>

#include <riprap/core/errors.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/dynamics/boundary/concepts.hpp>
#include <riprap/measurement/energy.hpp>

namespace riprap::internal {

/// Throws SimulationError if energies are not finite or the sample has dispersed.
template <class Sim>
void check_sample(const Sim& sim) {
  const double energy = kinetic_energy(sim.particles()) + stored_energy_of(sim);
  if (!std::isfinite(energy))
    throw SimulationError("kinetic and stored energy are no longer finite");
  const auto sample = sim.boundary().region(sim.particles());
  const Vec2 centre = centre_of(sample);
  const double far = 4 * Vec2(sample.semi_axes()).norm();
  if constexpr (!Sim::Domain::periodic)
    for (BodyIndex i = 0; i < sim.particles().size(); ++i) {
      const double distance = (sim.particles().body(i).position - centre).norm();
      if (sim.particles().body(i).is_free() && !(distance <= far))
        throw SimulationError(particle_text(sim.particles().ancestry(i).id) +
                              " has been thrown out of the sample: " + to_text(distance) +
                              " m from its centre");
    }
}

}  // namespace riprap::internal
