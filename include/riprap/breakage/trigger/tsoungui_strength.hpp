// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A particle splits as a disc under all its contact forces: hydrostatic part and equivalent
/// diametral compression.

#include <riprap/breakage/trigger/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// (sigma_1 - 3 sigma_3) / 2 >= strength, with the principal values of the mean stress: the tension
/// in the middle of an elastic disc under radial forces, whatever their number. The diametral
/// compression F = pi D t (sigma_1 - 3 sigma_3) / 4 has the same 2 F / (pi D t). After Tsoungui,
/// Vallet and Charmet (1999), who reduce the contact forces on a disc to a hydrostatic part and a
/// diametral compression; a hydrostatic load breaks nothing. Goes with MeanStressLine.
struct TsounguiStrength {
  double strength = 12e6;  ///< tensile, of a Brazilian test [Pa]

  [[nodiscard]] FailureMode operator()(const LoadedParticle& particle) const {
    const PrincipalValues mean = particle.mean_stress().principal_values();
    return 0.5 * (mean.major - 3 * mean.minor) >= strength ? FailureMode::tension
                                                           : FailureMode::intact;
  }

  static void for_each_field(auto& self, auto&& visit) { visit("strength", self.strength); }

  void validate() const { require_positive("TsounguiStrength.strength", strength); }
};

static_assert(LoadTrigger<TsounguiStrength>);

}  // namespace riprap
