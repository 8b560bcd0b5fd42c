// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A particle splits under its two largest opposed contact forces as in a Brazilian test.

#include <numbers>

#include <riprap/breakage/failure/opposed_forces.hpp>
#include <riprap/breakage/trigger/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// 2 F / (pi D t) >= strength (Cundall and Hart 1985), the tension across the loaded diameter of a
/// disc; F is the force of `largest_opposed_forces`. D is the distance of their points: the loaded
/// diameter of a disc, and the size that counts in point load tests on lumps of any shape (ISRM
/// 1985). Other contact forces play no part. Goes with LoadedDiameter.
struct BrazilianStrength {
  double strength = 12e6;  ///< tensile, of a Brazilian test [Pa]

  [[nodiscard]] FailureMode operator()(const LoadedParticle& particle) const {
    const std::optional<OpposedForces> pair = largest_opposed_forces(particle);
    if (!pair) return FailureMode::intact;
    const double tension =
        2 * pair->force / (std::numbers::pi * pair->distance * particle.thickness());
    return tension >= strength ? FailureMode::tension : FailureMode::intact;
  }

  static void for_each_field(auto& self, auto&& visit) { visit("strength", self.strength); }

  void validate() const { require_positive("BrazilianStrength.strength", strength); }
};

static_assert(LoadTrigger<BrazilianStrength>);

}  // namespace riprap
