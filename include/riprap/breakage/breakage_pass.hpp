// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Breakage pass: which particles break now, and along which lines.

#include <algorithm>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include <riprap/breakage/breakage_input.hpp>
#include <riprap/breakage/crack.hpp>
#include <riprap/breakage/particle_failure.hpp>
#include <riprap/breakage/refused_cuts.hpp>
#include <riprap/core/step_phase.hpp>

namespace riprap {

/// Checks every free particle: loads, element stresses, failed elements, trigger, line, cut.
/// Element stresses and failed elements are left out where neither trigger nor line fit needs them.
/// A refused cut is not tried again until the contact partners of the particle change.
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
    if constexpr (Input::needs_elements) input.operators.begin_epoch(particles.size());
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
  // Evaluates particle i; if it breaks, stores its crack, or that its cut was refused.
  template <class Input>
  void check(const Input& input, BodyIndex i) {
    const auto& breakage = input.breakage;
    constexpr bool by_loads = LoadTrigger<std::remove_cvref_t<decltype(breakage.trigger)>>;
    const CriterionView criterion{input.criterion(i)};
    const LoadedParticle particle{input.particles, i, loads_over_strength(input, i), input.rock(i),
                                  criterion};
    FailureMode mode = FailureMode::intact;
    if constexpr (by_loads) {
      for (const ContactLoad& load : particle.loads()) require_finite(load);
      mode = breakage.trigger(particle);
      if (mode == FailureMode::intact) return;
    }
    std::optional<Crack> crack;
    if constexpr (Input::needs_elements) {
      const InfluenceOperator& op = input.operators.exact(i, input.builder(i));
      const auto& [stress, failures] =
          evaluate_particle(breakage, input.stress.support, op, input.rock(i), input.particles, i,
                            loads_.of(i), evaluate_);
      if constexpr (!by_loads)
        if (!fires(breakage.trigger, failures, particle)) return;
      crack =
          find_crack(breakage, failures, op.sampling_points(), stress, particle, input.mean_area);
    } else if (const std::optional<Line> line = breakage.line_fit(particle)) {
      crack = crack_along(breakage, *line, particle.ring(), input.mean_area);
    }
    if (!crack) return refused_.add(input.particles, i, loads_.of(i));
    if constexpr (by_loads) crack->mode = mode;
    cracks_.emplace_back(i, std::move(*crack));
  }

  // The loads that a LoadedParticle has.
  template <class Input>
  std::span<const ContactLoad> loads_over_strength(const Input& input, BodyIndex i) {
    if constexpr (!Input::needs_loaded_particle) {
      return loads_.of(i);
    } else {
      const double scale = input.scale(i);
      if (scale == 1) return loads_.of(i);
      over_strength_.assign(loads_.of(i).begin(), loads_.of(i).end());
      for (ContactLoad& load : over_strength_) {
        load.force_lab *= scale;
        load.normal_force *= scale;
      }
      return over_strength_;
    }
  }

  ContactLoads loads_;
  std::vector<ContactLoad> over_strength_;
  RefusedCuts refused_;
  StressEvaluation evaluate_;
  std::vector<BodyIndex> candidates_;
  Cracks cracks_;
};

}  // namespace riprap
