// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Scale of the loads on a particle, from its strength.

#include <riprap/breakage/trigger/concepts.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// What the stress of particle i is multiplied by: one over the particle's own strength, for
/// triggers that have one; the criterion stays as it is.
template <Trigger T>
[[nodiscard]] double load_scale(const T& trigger, const Particles& particles, BodyIndex i) {
  if constexpr (HasStrengthFactor<T>)
    return 1 / trigger.strength_factor(particles.ancestry(i).id, particles.shape(i).area);
  else
    return 1;
}

}  // namespace riprap
