// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Scale of the loads on a particle, from its strength.

#include <riprap/breakage/trigger/concepts.hpp>
#include <riprap/material/rock.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// What the stress of particle i is multiplied by: one over the strength factor of its rock and,
/// for triggers that have one, the particle's own; the criterion stays as it is.
template <Trigger T>
[[nodiscard]] double load_scale(const T& trigger, const Particles& particles, BodyIndex i,
                                const Rock& rock) {
  if constexpr (HasStrengthFactor<T>)
    return 1 / (rock.strength_factor *
                trigger.strength_factor(particles.ancestry(i).id, particles.shape(i).area));
  else
    return 1 / rock.strength_factor;
}

}  // namespace riprap
