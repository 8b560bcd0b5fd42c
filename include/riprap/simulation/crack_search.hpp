// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Which particles are to break now, and along which lines.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <riprap/breakage/crack.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/execution/serial.hpp>
#include <riprap/core/step_part.hpp>
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
  /// @param lap is told when a part of the step is done
  template <class BreakagePart, class Contacts, class StressPart, Execution E = Serial,
            class Lap = NoLaps>
  const Cracks& find(const BreakagePart& breakage, const Particles& particles,
                     const Contacts& contacts, ParticleStress<StressPart>& stresses,
                     double mean_area, const E& execution = {}, Lap&& lap = {}) {
    refusals_.resize(particles.size());
    find_suspects(breakage, particles, contacts, stresses, execution);
    lap(StepPart::stress_bound);
    if constexpr (foreseen<BreakagePart, StressPart>)
      clear_suspects(breakage, particles, stresses, execution);
    cracks_.clear();
    for (const BodyIndex i : suspects_)
      naming_particle(particles, i, [&] { check(breakage, particles, i, stresses, mean_area); });
    std::sort(cracks_.begin(), cracks_.end(), [&](const auto& p, const auto& q) {
      return particles.ancestry(p.first).id < particles.ancestry(q.first).id;
    });
    lap(StepPart::stress_check);
    return cracks_;
  }

 private:
  template <class BreakagePart, class StressPart>
  static constexpr bool foreseen = ParticleStress<StressPart>::linear &&
                                   requires(const BreakagePart& breakage, std::size_t elements) {
                                     breakage.trigger.failed_elements_needed(elements);
                                   };

  // Whether particle i has to be evaluated. Depends on i alone, and changes nothing of others.
  template <class BreakagePart, class Contacts, class StressPart>
  [[nodiscard]] bool asks(const BreakagePart&, const Particles& particles, const Contacts& contacts,
                          BodyIndex i, ParticleStress<StressPart>& stresses) {
    if (!particles.body(i).is_free()) return false;
    stresses.gather(contacts, i);
    Refusal& refusal = refusals_[i];
    if (refusal.active && refusal.partners == stresses.partners(particles, i)) return false;
    refusal.active = false;
    if constexpr (foreseen<BreakagePart, StressPart>) {
      if (stresses.contact_count(i) > 0) return !stresses.known_to_hold(particles, i);
      stresses.watch_for_contacts(i);
    }
    return stresses.contact_count(i) > 0;
  }

  // Runs `work`, and says of which particle it was if its input broke a rule.
  template <class Work>
  static void naming_particle(const Particles& particles, BodyIndex i, Work&& work) {
    try {
      work();
    } catch (const InvalidInput& error) {
      throw SimulationError(particle_text(particles.ancestry(i).id) + ": " + error.what());
    }
  }

  // Evaluates particle i and keeps its crack, or that its cut was refused.
  template <class BreakagePart, class StressPart>
  void check(const BreakagePart& breakage, const Particles& particles, BodyIndex i,
             ParticleStress<StressPart>& stresses, double mean_area) {
    const ElementStress& stress =
        stresses.evaluate(particles, i, load_scale(breakage.trigger, particles, i));
    const FailureTally tally = tally_failures(breakage.criterion, stress);
    if (!breakage.trigger(tally)) return;
    std::optional<Crack> crack =
        find_crack(breakage, tally, stresses.influence(particles, i).mesh(), stress,
                   particles.body(i), particles.ring(i), mean_area);
    if (crack)
      cracks_.emplace_back(i, std::move(*crack));
    else
      refusals_[i] = {true, stresses.partners(particles, i)};
  }

  // Everyone that has to be evaluated, in order.
  template <class BreakagePart, class Contacts, class StressPart, Execution E>
  void find_suspects(const BreakagePart& breakage, const Particles& particles,
                     const Contacts& contacts, ParticleStress<StressPart>& stresses,
                     const E& execution) {
    stresses.begin_gather(particles, contacts);
    task_suspects_.resize(task_count(particles.size()));
    for_each_task(execution, particles.size(),
                  [&](std::size_t task, std::size_t first, std::size_t last) {
                    task_suspects_[task].clear();
                    const auto ask = [&](BodyIndex i) {
                      if (asks(breakage, particles, contacts, i, stresses))
                        task_suspects_[task].push_back(i);
                    };
                    if constexpr (foreseen<BreakagePart, StressPart>) {
                      stresses.watch_task(particles, contacts, task, first, last, ask);
                    } else {
                      stresses.begin_task(task);
                      for (auto i = static_cast<BodyIndex>(first); i < last; ++i) ask(i);
                    }
                  });
    suspects_.clear();
    for (const auto& some : task_suspects_)
      suspects_.insert(suspects_.end(), some.begin(), some.end());
  }

  // Leaves those of whom the exact stresses have to decide.
  template <class BreakagePart, class StressPart, Execution E>
  void clear_suspects(const BreakagePart& breakage, const Particles& particles,
                      ParticleStress<StressPart>& stresses, const E& execution) {
    if (workspaces_.empty()) {
      const FailureForecast forecast(FailureRadii::of(breakage.criterion));
      workspaces_.assign(shares, StressWorkspace{forecast});
    }
    const auto& trigger = breakage.trigger;
    const auto needed = [&](std::size_t elements) -> std::size_t {
      return trigger.failed_elements_needed(elements);
    };
    may_break_.resize(suspects_.size());
    // Some at a time, for in between operators may have to be dropped.
    constexpr std::size_t batch = 1024;
    for (std::size_t first = 0; first < suspects_.size(); first += batch) {
      const std::size_t last = std::min(first + batch, suspects_.size());
      execution.run(std::min(shares, last - first), [&](std::size_t share) {
        for (std::size_t k = first + share; k < last; k += shares) {
          const BodyIndex i = suspects_[k];
          naming_particle(particles, i, [&] {
            may_break_[k] = stresses.may_break(particles, i, load_scale(trigger, particles, i),
                                               needed, workspaces_[share]);
          });
        }
      });
      stresses.trim_operators();
    }
    std::size_t kept = 0;
    for (std::size_t k = 0; k < suspects_.size(); ++k)
      if (may_break_[k]) suspects_[kept++] = suspects_[k];
    suspects_.resize(kept);
  }

  static constexpr std::size_t shares = 16;  // more than any threads are likely to be

  /// A refused cut and the partners it was refused under.
  struct Refusal {
    bool active = false;
    std::uint64_t partners = 0;
  };

  std::vector<Refusal> refusals_;
  std::vector<std::vector<BodyIndex>> task_suspects_;
  std::vector<BodyIndex> suspects_;
  std::vector<unsigned char> may_break_;     // suspect by suspect
  std::vector<StressWorkspace> workspaces_;  // with the criterion of the first search
  Cracks cracks_;
};

}  // namespace riprap
