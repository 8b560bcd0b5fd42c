// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A particle breaks when its mean stress fails by the criterion of the model.

#include <riprap/breakage/trigger/concepts.hpp>

namespace riprap {

/// The criterion applied to the mean stress of the particle, as in codes for crushable polyhedra
/// (by von Mises: Elias 2014; by Mohr and Coulomb: Gladkyy and Kuna 2017). Between two opposed
/// forces a particle has no mean tension: a disc breaks where 2 F / (pi D t) is half of its
/// uniaxial strength, in shear. Goes with MeanStressFailurePlane.
struct MeanStressFailure {
  [[nodiscard]] FailureMode operator()(const LoadedParticle& particle) const {
    return particle.criterion().evaluate(particle.mean_stress()).mode;
  }
};

static_assert(LoadTrigger<MeanStressFailure>);

}  // namespace riprap
