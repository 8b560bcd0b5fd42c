// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Breakage pass: which particles break now, and along which lines.

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <riprap/breakage/breakage_input.hpp>
#include <riprap/breakage/crack.hpp>
#include <riprap/breakage/particle_failure.hpp>
#include <riprap/breakage/refused_cuts.hpp>
#include <riprap/core/step_phase.hpp>

namespace riprap {

/// Checks every free particle: loads, element stresses, failed elements, trigger, line, cut. A
/// refused cut is not tried again until the contact partners of the particle change.
class BreakagePass {
 public:
  using Cracks = std::vector<std::pair<BodyIndex, Crack>>;

  /// Cracks in the order of particle ids; the reference is valid until the next call.
  /// @param screening state of a Screening: leaves out particles that do not break
  /// @param on_phase_end called with each phase of the step that has ended
  template <class Input, class ScreeningState, class OnPhaseEnd = NoPhaseTimer>
  const Cracks& find(const Input& input, ScreeningState& screening,
                     OnPhaseEnd&& on_phase_end = {}) {
    const Particles& particles = input.particles;
    refused_.resize(particles.size());
    loads_.begin(input.contacts, particles.size());
    input.operators.begin_epoch(particles.size());
    const auto is_loaded = [&](BodyIndex i) {
      return particles.body(i).is_free() && !refused_.contains(particles, i, loads_.of(i)) &&
             !loads_.of(i).empty();
    };
    candidates_.clear();
    screening.find_candidates(input, loads_, is_loaded, candidates_, on_phase_end);
    cracks_.clear();
    for (const BodyIndex i : candidates_) naming_particle(particles, i, [&] { check(input, i); });
    std::sort(cracks_.begin(), cracks_.end(), [&](const auto& p, const auto& q) {
      return particles.ancestry(p.first).id < particles.ancestry(q.first).id;
    });
    on_phase_end(StepPhase::stress_check);
    return cracks_;
  }
  /// Those of the last call.
  [[nodiscard]] const Cracks& cracks() const { return cracks_; }

  /// Particle i was removed; those behind it have moved up.
  void remove(BodyIndex i) { refused_.remove(i); }

  static void for_each_field(auto& self, auto&& visit) { visit("refused_cuts", self.refused_); }

 private:
  // Evaluates particle i and stores its crack, or that its cut was refused.
  template <class Input>
  void check(const Input& input, BodyIndex i) {
    const InfluenceOperator& op = input.operators.exact(i, input.builder(i));
    const auto& [stress, failures] = evaluate_particle(input.breakage, input.stress.support, op,
                                                       input.particles, i, loads_.of(i), evaluate_);
    if (!input.breakage.trigger(failures)) return;
    std::optional<Crack> crack =
        find_crack(input.breakage, failures, op.sampling_points(), stress, input.particles.body(i),
                   input.particles.ring(i), input.mean_area);
    if (crack)
      cracks_.emplace_back(i, std::move(*crack));
    else
      refused_.add(input.particles, i, loads_.of(i));
  }

  ContactLoads loads_;
  RefusedCuts refused_;
  StressEvaluation evaluate_;
  std::vector<BodyIndex> candidates_;
  Cracks cracks_;
};

}  // namespace riprap
