#pragma once
/// @file
/// Which particles are to break now, and along which lines.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <riprap/breakage/crack.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/simulation/particle_stress.hpp>

namespace riprap {

/// What the stress of particle i is multiplied by: one over the particle's own strength, for
/// triggers that know one; the criterion stays as it is.
template <class Trigger>
[[nodiscard]] double load_scale(const Trigger& trigger, const Particles& particles, BodyIndex i) {
  const ParticleId id = particles.ancestry(i).id;
  const double area = particles.shape(i).area;
  if constexpr (requires { trigger.strength_factor(id, area); })
    return 1 / trigger.strength_factor(id, area);
  else
    return 1;
}

/// Asks every free particle whether it breaks. Remembers refused cuts until the contact partners
/// change; passes over particles that cannot have come to breaking since they were last asked, if
/// the trigger says what that takes. The cracks are those of asking everyone.
class CrackSearch {
 public:
  using Cracks = std::vector<std::pair<BodyIndex, Crack>>;

  /// Cracks in the order of particle ids; the reference is good until the next call.
  /// @param mean_area of the intact particles [m^2]
  template <class BreakagePart, class Contacts, class StressPart>
  const Cracks& find(const BreakagePart& breakage, const Particles& particles,
                     const Contacts& contacts, ParticleStress<StressPart>& stresses,
                     double mean_area) {
    refusals_.resize(particles.size());
    stresses.gather(particles, contacts);
    suspects_.clear();
    for (BodyIndex i = 0; i < particles.size(); ++i)
      if (asks(breakage, particles, i, stresses)) suspects_.push_back(i);
    cracks_.clear();
    for (const BodyIndex i : suspects_) {
      if (!may_break(breakage, particles, i, stresses)) continue;
      const ElementStress& stress =
          stresses.evaluate(particles, i, load_scale(breakage.trigger, particles, i));
      const FailureTally tally = tally_failures(breakage.criterion, stress);
      if (!breakage.trigger(tally)) continue;
      std::optional<Crack> crack =
          find_crack(breakage, tally, stresses.influence(particles, i).mesh(), stress,
                     particles.body(i), particles.ring(i), mean_area);
      if (crack)
        cracks_.emplace_back(i, std::move(*crack));
      else
        refusals_[i] = {true, stresses.partners(particles, i)};
    }
    std::sort(cracks_.begin(), cracks_.end(), [&](const auto& p, const auto& q) {
      return particles.ancestry(p.first).id < particles.ancestry(q.first).id;
    });
    return cracks_;
  }

 private:
  template <class BreakagePart, class StressPart>
  static constexpr bool foreseen = ParticleStress<StressPart>::linear &&
                                   requires(const BreakagePart& breakage, std::size_t elements) {
                                     breakage.trigger.failed_elements_needed(elements);
                                   };

  // Whether particle i has to be evaluated. Depends on i alone, and changes nothing of others.
  template <class BreakagePart, class StressPart>
  [[nodiscard]] bool asks(const BreakagePart&, const Particles& particles, BodyIndex i,
                          const ParticleStress<StressPart>& stresses) {
    if (!particles.body(i).is_free()) return false;
    Refusal& refusal = refusals_[i];
    if (refusal.active && refusal.partners == stresses.partners(particles, i)) return false;
    refusal.active = false;
    if (stresses.contact_count(i) == 0) return false;
    if constexpr (foreseen<BreakagePart, StressPart>) return !stresses.known_to_hold(particles, i);
    return true;
  }

  // Whether the exact stresses of particle i have to decide.
  template <class BreakagePart, class StressPart>
  [[nodiscard]] bool may_break(const BreakagePart& breakage, const Particles& particles,
                               BodyIndex i, ParticleStress<StressPart>& stresses) {
    if constexpr (foreseen<BreakagePart, StressPart>) {
      if (!forecast_) forecast_ = FailureForecast(FailureRadii::of(breakage.criterion));
      const auto& trigger = breakage.trigger;
      return stresses.may_break(particles, i, load_scale(trigger, particles, i), *forecast_,
                                [&](std::size_t elements) -> std::size_t {
                                  return trigger.failed_elements_needed(elements);
                                });
    } else {
      return true;
    }
  }

  /// A refused cut and the partners it was refused under.
  struct Refusal {
    bool active = false;
    std::uint64_t partners = 0;
  };

  std::vector<Refusal> refusals_;
  std::vector<BodyIndex> suspects_;
  std::optional<FailureForecast> forecast_;  // of the criterion of the first search
  Cracks cracks_;
};

}  // namespace riprap
