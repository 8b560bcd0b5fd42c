// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Any trigger with the random strengths of WeibullStrength.

#include <cstddef>
#include <cstdint>

#include <riprap/breakage/trigger/weibull_strength.hpp>

namespace riprap {

/// Decides as `trigger` does, of loads over the strength factor of the particle.
template <Trigger TriggerT>
  requires(!HasStrengthFactor<TriggerT>)
struct WithWeibullStrength {
  TriggerT trigger{};
  double modulus = 5;            ///< as of WeibullStrength [-]; infinity: `trigger` alone
  double reference_area = 2e-4;  ///< [m^2]
  std::uint64_t seed = 1;
  double dimension = 2;  ///< of the size effect [-]: strength falls as d^(-dimension / modulus)

  /// Strength of a particle over that of `trigger` and criterion [-].
  [[nodiscard]] double strength_factor(ParticleId id, double area) const {
    return strength().strength_factor(id, area);
  }
  [[nodiscard]] bool operator()(const FailureCount& failures) const
    requires(requirements::TriggerByCount<TriggerT>)
  {
    return trigger(failures);
  }
  [[nodiscard]] bool operator()(const FailureCount& failures, const LoadedParticle& particle) const
    requires(requirements::TriggerByCountAndLoads<TriggerT>)
  {
    return trigger(failures, particle);
  }
  [[nodiscard]] FailureMode operator()(const LoadedParticle& particle) const
    requires(LoadTrigger<TriggerT>)
  {
    return trigger(particle);
  }
  [[nodiscard]] std::size_t failed_elements_needed(std::size_t elements) const
    requires requires(const TriggerT& t) { t.failed_elements_needed(elements); }
  {
    return trigger.failed_elements_needed(elements);
  }
  [[nodiscard]] double failed_area_needed() const
    requires requires(const TriggerT& t) { t.failed_area_needed(); }
  {
    return trigger.failed_area_needed();
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("trigger", self.trigger);
    visit("modulus", self.modulus);
    visit("reference_area", self.reference_area);
    visit("seed", self.seed);
    visit("dimension", self.dimension);
  }

  void validate() const {
    riprap::validate(trigger);
    strength().validate();
  }

 private:
  [[nodiscard]] WeibullStrength strength() const {
    return {
        .modulus = modulus, .reference_area = reference_area, .seed = seed, .dimension = dimension};
  }
};
template <class T>
WithWeibullStrength(T) -> WithWeibullStrength<T>;

}  // namespace riprap
