// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// From the contact loads on a particle to its failed elements.

#include <span>

#include <riprap/breakage/failure/failure_count.hpp>
#include <riprap/breakage/trigger/load_scale.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/stress/contact_loads.hpp>
#include <riprap/stress/particle_stress.hpp>

namespace riprap {

/// Stress in a particle, and the elements that fail under it.
struct ParticleFailure {
  const ElementStress& stress;  ///< in the particle's own frame; valid until the next evaluation
  FailureCount failures;
};

/// Of particle i of a rock under `loads`, divided by its strength factor.
/// @param breakage offers `criterion` and `trigger`
/// @param support of the particle, @param op its influence operator
/// @param evaluate keeps the stress
/// Throws InvalidInput for a load that is not finite.
template <class BreakagePart, class Support>
[[nodiscard]] ParticleFailure
evaluate_particle(const BreakagePart& breakage, const Support& support, const InfluenceOperator& op,
                  const Rock& rock, const Particles& particles, BodyIndex i,
                  std::span<const ContactLoad> loads, StressEvaluation& evaluate) {
  const ElementStress& stress = evaluate(op, support, particles.body(i).rotation, loads,
                                         load_scale(breakage.trigger, particles, i, rock));
  return {stress, count_failures(criterion_of(breakage.criterion, particles.material(i)), stress,
                                 op.sampling_points(), particles.shape(i).area)};
}

}  // namespace riprap
