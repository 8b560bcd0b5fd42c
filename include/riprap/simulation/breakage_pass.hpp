// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Breakage pass: which particles break now, and along which lines.

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <riprap/breakage/crack.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/execution/serial.hpp>
#include <riprap/core/step_phase.hpp>
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

/// Checks every free particle for breakage. A refused cut is not tried again until the contact
/// partners of the particle change. Particles that cannot break since their last check are skipped
/// (screening), if the trigger states how many failed elements it needs; the cracks are the same as
/// without screening.
class BreakagePass {
 public:
  using Cracks = std::vector<std::pair<BodyIndex, Crack>>;

  /// Cracks in the order of particle ids; the reference is valid until the next call.
  /// @param mean_area of the intact particles [m^2]
  /// @param on_phase_end called with each phase of the step that has ended
  template <class BreakagePart, class Contacts, class StressPart, Execution E = Serial,
            class OnPhaseEnd = NoPhaseTimer>
  const Cracks& find(const BreakagePart& breakage, const Particles& particles,
                     const Contacts& contacts, ParticleStress<StressPart>& stresses,
                     double mean_area, const E& execution = {}, OnPhaseEnd&& on_phase_end = {}) {
    refusals_.resize(particles.size());
    find_candidates(breakage, particles, contacts, stresses, execution);
    on_phase_end(StepPhase::stress_bound);
    if constexpr (screened<BreakagePart, StressPart>)
      screen_candidates(breakage, particles, stresses, execution);
    cracks_.clear();
    for (const BodyIndex i : candidates_)
      naming_particle(particles, i, [&] { check(breakage, particles, i, stresses, mean_area); });
    std::sort(cracks_.begin(), cracks_.end(), [&](const auto& p, const auto& q) {
      return particles.ancestry(p.first).id < particles.ancestry(q.first).id;
    });
    on_phase_end(StepPhase::stress_check);
    return cracks_;
  }

 private:
  template <class BreakagePart, class StressPart>
  static constexpr bool screened = ParticleStress<StressPart>::linear &&
                                   requires(const BreakagePart& breakage, std::size_t elements) {
                                     breakage.trigger.failed_elements_needed(elements);
                                   };

  // Whether particle i has to be evaluated. Reads and changes data of particle i only.
  template <class BreakagePart, class Contacts, class StressPart>
  [[nodiscard]] bool needs_check(const BreakagePart&, const Particles& particles,
                                 const Contacts& contacts, BodyIndex i,
                                 ParticleStress<StressPart>& stresses) {
    if (!particles.body(i).is_free()) return false;
    stresses.gather(contacts, i);
    Refusal& refusal = refusals_[i];
    if (refusal.active && refusal.partners == stresses.partners(particles, i)) return false;
    refusal.active = false;
    if constexpr (screened<BreakagePart, StressPart>) {
      if (stresses.contact_count(i) > 0) return !stresses.bound_excludes_failure(particles, i);
      stresses.track_without_contacts(i);
    }
    return stresses.contact_count(i) > 0;
  }

  // Runs `work`; names the particle if its input breaks a rule.
  template <class Work>
  static void naming_particle(const Particles& particles, BodyIndex i, Work&& work) {
    try {
      work();
    } catch (const InvalidInput& error) {
      throw SimulationError(particle_text(particles.ancestry(i).id) + ": " + error.what());
    }
  }

  // Evaluates particle i and stores its crack, or that its cut was refused.
  template <class BreakagePart, class StressPart>
  void check(const BreakagePart& breakage, const Particles& particles, BodyIndex i,
             ParticleStress<StressPart>& stresses, double mean_area) {
    const ElementStress& stress =
        stresses.evaluate(particles, i, load_scale(breakage.trigger, particles, i));
    const FailureCount failures = count_failures(breakage.criterion, stress);
    if (!breakage.trigger(failures)) return;
    std::optional<Crack> crack =
        find_crack(breakage, failures, stresses.influence(particles, i).mesh(), stress,
                   particles.body(i), particles.ring(i), mean_area);
    if (crack)
      cracks_.emplace_back(i, std::move(*crack));
    else
      refusals_[i] = {true, stresses.partners(particles, i)};
  }

  // All particles that have to be evaluated, in order.
  template <class BreakagePart, class Contacts, class StressPart, Execution E>
  void find_candidates(const BreakagePart& breakage, const Particles& particles,
                       const Contacts& contacts, ParticleStress<StressPart>& stresses,
                       const E& execution) {
    stresses.begin_gather(particles, contacts);
    task_candidates_.resize(task_count(particles.size()));
    for_each_task(
        execution, particles.size(), [&](std::size_t task, std::size_t first, std::size_t last) {
          task_candidates_[task].clear();
          const auto check_one = [&](BodyIndex i) {
            if (needs_check(breakage, particles, contacts, i, stresses))
              task_candidates_[task].push_back(i);
          };
          if constexpr (screened<BreakagePart, StressPart>) {
            stresses.check_incremental_bounds(particles, contacts, task, first, last, check_one);
          } else {
            stresses.begin_task(task);
            for (auto i = static_cast<BodyIndex>(first); i < last; ++i) check_one(i);
          }
        });
    candidates_.clear();
    for (const auto& some : task_candidates_)
      candidates_.insert(candidates_.end(), some.begin(), some.end());
  }

  // Screens the candidates in single precision; keeps those whose exact stresses decide.
  template <class BreakagePart, class StressPart, Execution E>
  void screen_candidates(const BreakagePart& breakage, const Particles& particles,
                         ParticleStress<StressPart>& stresses, const E& execution) {
    if (workspaces_.empty()) {
      const FailureScreening screening(MohrRadiusTable::of(breakage.criterion));
      workspaces_.assign(shares, StressWorkspace{screening});
    }
    const auto& trigger = breakage.trigger;
    const auto needed = [&](std::size_t elements) -> std::size_t {
      return trigger.failed_elements_needed(elements);
    };
    may_fail_.resize(candidates_.size());
    // In chunks, since operators may have to be evicted in between.
    constexpr std::size_t batch = 1024;
    for (std::size_t first = 0; first < candidates_.size(); first += batch) {
      const std::size_t last = std::min(first + batch, candidates_.size());
      execution.run(std::min(shares, last - first), [&](std::size_t share) {
        for (std::size_t k = first + share; k < last; k += shares) {
          const BodyIndex i = candidates_[k];
          naming_particle(particles, i, [&] {
            may_fail_[k] = stresses.screen(particles, i, load_scale(trigger, particles, i), needed,
                                           workspaces_[share]);
          });
        }
      });
      stresses.evict_operators();
    }
    std::size_t kept = 0;
    for (std::size_t k = 0; k < candidates_.size(); ++k)
      if (may_fail_[k]) candidates_[kept++] = candidates_[k];
    candidates_.resize(kept);
  }

  static constexpr std::size_t shares = 16;  // more than the usual number of threads

  // A refused cut, with the contact partners it was refused under.
  struct Refusal {
    bool active = false;
    std::uint64_t partners = 0;
  };

  std::vector<Refusal> refusals_;
  std::vector<std::vector<BodyIndex>> task_candidates_;
  std::vector<BodyIndex> candidates_;
  std::vector<unsigned char> may_fail_;      // of each candidate
  std::vector<StressWorkspace> workspaces_;  // with the criterion of the first search
  Cracks cracks_;
};

}  // namespace riprap
