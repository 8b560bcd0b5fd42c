// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Screening: skips particles whose stresses provably changed too little for them to break.

#include <algorithm>
#include <span>
#include <utility>
#include <vector>

#include <riprap/acceleration/screening/failure_screening.hpp>
#include <riprap/acceleration/screening/stress_change_bound.hpp>
#include <riprap/acceleration/screening/tracked_bounds.hpp>
#include <riprap/breakage/breakage_input.hpp>
#include <riprap/breakage/screening/evaluate_all.hpp>
#include <riprap/breakage/trigger/concepts.hpp>
#include <riprap/core/step_phase.hpp>
#include <riprap/stress/contact_loads.hpp>
#include <riprap/stress/support/concepts.hpp>

namespace riprap {

/// Screening of three stages, each for what the one before leaves: an incremental bound, contact by
/// contact; the bound on the change of stress since a reference; an evaluation in single precision
/// with an error bound, which becomes the reference if the particle cannot break. Needs a
/// LinearSupport and a ScreenableTrigger, and an OperatorStore with operators in single precision;
/// under other supports and triggers every particle is evaluated. The default.
struct StressBoundScreening {
  template <class BreakagePart, class StressPart>
  class State : public EvaluateAll::State<BreakagePart, StressPart> {
   public:
    using EvaluateAll::State<BreakagePart, StressPart>::State;
  };

  template <class BreakagePart, class StressPart>
    requires ScreenableTrigger<decltype(BreakagePart::trigger)> &&
             LinearSupport<decltype(StressPart::support)>
  class State<BreakagePart, StressPart>;
};

template <class BreakagePart, class StressPart>
  requires ScreenableTrigger<decltype(BreakagePart::trigger)> &&
           LinearSupport<decltype(StressPart::support)>
class StressBoundScreening::State<BreakagePart, StressPart> {
 public:
  State(const BreakagePart& breakage, const StressPart& stress)
      : unscreened_(breakage, stress), active_(stress.support.is_linear()),
        workspaces_(shares, Workspace{screenings_of(breakage.criterion)}) {}

  template <class Input, class IsLoaded, class OnPhaseEnd>
  void find_candidates(const Input& input, ContactLoads& loads, IsLoaded&& is_loaded,
                       std::vector<BodyIndex>& candidates, OnPhaseEnd&& on_phase_end) {
    static_assert(
        requires { input.operators.single_precision(BodyIndex{}, input.builder(0)); },
        "riprap: StressBoundScreening needs an OperatorStore with operators in single "
        "precision, such as OperatorCache");
    if (!active_)
      return unscreened_.find_candidates(input, loads, is_loaded, candidates, on_phase_end);
    check_bounds(input, loads, is_loaded, candidates);
    on_phase_end(StepPhase::stress_bound);
    evaluate_in_single_precision(input, loads, candidates);
  }
  void forget(BodyIndex i) {
    if (i < bounds_.size()) bounds_[i].clear();
    tracked_.untrack(i);
  }

 private:
  // Workspace of one thread.
  struct Workspace {
    std::vector<FailureScreening> screenings;  // one, or one of each material
    std::vector<BoundaryLoad> loads{};
    std::vector<LocatedPoint> points{};
    ElementStressF32 stress{};
    WeightedInfluence influence{};
  };
  using CriterionT = decltype(BreakagePart::criterion);
  [[nodiscard]] static std::vector<FailureScreening> screenings_of(const CriterionT& criterion) {
    std::vector<FailureScreening> all;
    if constexpr (MaterialCriterion<CriterionT>)
      for (std::size_t m = 0; m < criterion.materials(); ++m)
        all.emplace_back(MohrRadiusTable::of(criterion.of_material(static_cast<MaterialIndex>(m))));
    else
      all.emplace_back(MohrRadiusTable::of(criterion));
    return all;
  }

  static constexpr std::size_t shares = 16;  // more than the usual number of threads

  // All particles whose bounds do not exclude that they break, in order.
  template <class Input, class IsLoaded>
  void check_bounds(const Input& input, ContactLoads& loads, IsLoaded&& is_loaded,
                    std::vector<BodyIndex>& candidates) {
    const Particles& particles = input.particles;
    tracked_.begin(input.contacts, particles.size());
    bounds_.resize(particles.size());
    task_candidates_.resize(task_count(particles.size()));
    for_each_task(input.execution, particles.size(),
                  [&](std::size_t task, std::size_t first, std::size_t last) {
                    task_candidates_[task].clear();
                    tracked_.check(particles, input.contacts, task, first, last, [&](BodyIndex i) {
                      if (!particles.body(i).is_free()) return;
                      loads.gather(input.contacts, i);
                      if (is_loaded(i) && !bound_excludes_failure(particles, loads, i))
                        task_candidates_[task].push_back(i);
                      else if (loads.of(i).empty())
                        tracked_.track(i, {}, loads.sides(i), {});
                    });
                  });
    for (const auto& some : task_candidates_)
      candidates.insert(candidates.end(), some.begin(), some.end());
  }

  // Whether the bound on the change of stress of particle i since its reference excludes that it
  // breaks now. If so, its incremental bound starts from here.
  bool bound_excludes_failure(const Particles& particles, const ContactLoads& loads, BodyIndex i) {
    StressChangeBound::Sensitivities sensitivities;
    const bool holds =
        bounds_[i].within_limit(loads.of(i), particles.body(i).rotation, sensitivities);
    if (holds)
      tracked_.track(i, loads.of(i), loads.sides(i), sensitivities);
    else
      tracked_.untrack(i);
    return holds;
  }

  // Keeps the candidates whose exact stresses decide.
  template <class Input>
  void evaluate_in_single_precision(const Input& input, const ContactLoads& loads,
                                    std::vector<BodyIndex>& candidates) {
    may_fail_.resize(candidates.size());
    // In chunks, since operators may have to be evicted in between.
    constexpr std::size_t chunk = 1024;
    for (std::size_t first = 0; first < candidates.size(); first += chunk) {
      const std::size_t last = std::min(first + chunk, candidates.size());
      input.execution.run(std::min(shares, last - first), [&](std::size_t share) {
        for (std::size_t k = first + share; k < last; k += shares)
          naming_particle(input.particles, candidates[k], [&] {
            may_fail_[k] = may_fail(input, loads, candidates[k], workspaces_[share]);
          });
      });
      input.operators.evict();
    }
    std::size_t kept = 0;
    for (std::size_t k = 0; k < candidates.size(); ++k)
      if (may_fail_[k]) candidates[kept++] = candidates[k];
    candidates.resize(kept);
  }

  // False: the trigger does not fire for particle i, nor under loads close to these, whose bound
  // starts from here; true: it may fire. Threads may call it concurrently, each for other particles
  // and with a workspace of its own.
  template <class Input>
  bool may_fail(const Input& input, const ContactLoads& loads, BodyIndex i, Workspace& work) {
    const InfluenceOperatorF32& op = input.operators.single_precision(i, input.builder(i));
    const Rotation& rotation = input.particles.body(i).rotation;
    const double scale = input.scale(i);
    FailureScreening& screening =
        work.screenings[MaterialCriterion<CriterionT> ? input.particles.material(i) : 0];
    work.loads.clear();
    work.points.clear();
    for (const ContactLoad& load : loads.of(i)) {
      const LocatedPoint point = op.locator().nearest(rotation.inverse_times(load.arm_lab));
      work.loads.push_back({point.at, rotation.inverse_times(load.force_lab), load.normal_force});
      work.points.push_back(point);
    }
    op.find_stress(work.loads, scale, work.stress);
    const auto [may, stress_margin] = screened(input.breakage.trigger, op, screening, work);
    if (may || work.loads.size() > StressChangeBound::capacity) {
      bounds_[i].clear();
    } else {
      work.influence.assign(op, work.loads, work.points, screening.factors());
      bounds_[i].reset(loads.of(i), work.loads, work.points, rotation, work.influence,
                       stress_margin / scale);
    }
    (void)bound_excludes_failure(input.particles, loads, i);
    return may;
  }

  // Whether the trigger may fire, and below which change of all stresses it does not.
  template <class T>
  [[nodiscard]] static std::pair<bool, double>
  screened(const T& trigger, const InfluenceOperatorF32& op, FailureScreening& screening,
           const Workspace& work) {
    if constexpr (requires { trigger.failed_area_needed(); }) {
      const double needed = trigger.failed_area_needed() * static_cast<double>(op.elements());
      const ScreeningResult result = screening(work.stress, op.area_weights(), needed);
      return {result.possible > 0, result.stress_margin};
    } else {
      const std::size_t needed = trigger.failed_elements_needed(op.elements());
      const ScreeningResult result = screening(work.stress, needed);
      return {result.possible >= needed, result.stress_margin};
    }
  }

  EvaluateAll::State<BreakagePart, StressPart> unscreened_;
  bool active_;
  std::vector<StressChangeBound> bounds_;
  TrackedBounds tracked_;
  std::vector<std::vector<BodyIndex>> task_candidates_;
  std::vector<unsigned char> may_fail_;  // of each candidate
  std::vector<Workspace> workspaces_;
};

static_assert(Screening<StressBoundScreening>);

}  // namespace riprap
