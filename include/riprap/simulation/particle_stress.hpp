// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// From contact forces to element stresses, for every particle of a simulation.

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <riprap/acceleration/screening/failure_screening.hpp>
#include <riprap/contact/pair_index.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/execution/serial.hpp>
#include <riprap/core/splitmix64.hpp>
#include <riprap/material/rock.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/acceleration/operator_cache.hpp>
#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/element_stress.hpp>
#include <riprap/acceleration/screening/incremental_bound.hpp>
#include <riprap/acceleration/screening/stress_change_bound.hpp>
#include <riprap/stress/support/inertia_relief.hpp>

namespace riprap {

/// Workspace of one thread for the screening of a particle.
struct StressWorkspace {
  FailureScreening screening;
  std::vector<BoundaryLoad> balanced{};
  std::vector<LocatedPoint> places{};
  ElementStressF32 stress{};
};

/// The influence operators of all particles, the contact loads of the last `gather`, and for each
/// particle a reference load with a bound on the change of stress under which it does not break.
/// The bound is first checked incrementally, contact by contact; only particles beyond their budget
/// are gathered and compared with their reference.
template <class StressPart>
class ParticleStress {
 public:
  /// Whether stress is linear in the contact loads, so that superposition gives a bound on its
  /// change. Other supports choose the pinned contacts anew under every load.
  static constexpr bool linear = std::same_as<decltype(StressPart::support), InertiaRelief>;

  ParticleStress(StressPart model, const Rock& rock) : operators_(std::move(model), rock) {}

  /// Gathers the contact forces on every particle.
  template <class Contacts>
  void gather(const Particles& particles, const Contacts& contacts) {
    begin_gather(particles, contacts);
    for_each_task(Serial{}, particles.size(),
                  [&](std::size_t task, std::size_t first, std::size_t last) {
                    begin_task(task);
                    for (auto i = static_cast<BodyIndex>(first); i < last; ++i) gather(contacts, i);
                  });
  }

  /// The same for some particles, in independent tasks of `for_each_task`. `begin_gather` comes
  /// first, then `begin_task` or `check_incremental_bounds`.
  template <class Contacts>
  void begin_gather(const Particles& particles, const Contacts& contacts) {
    operators_.begin_epoch(particles.size());
    if (revision_ != contacts.revision() || tracked_contacts_.size() != particles.size()) {
      if constexpr (linear) move_sensitivities(contacts);
      revision_ = contacts.revision();
      index_.build(contacts.pairs(), particles.size());
      tracked_contacts_.resize(particles.size(), IncrementalBound::untracked);
    }
    bounds_.resize(particles.size());
    loads_.resize(particles.size());
    tasks_.resize(task_count(particles.size()));
  }
  void begin_task(std::size_t task) { tasks_[task].clear(); }
  template <class Contacts>
  void gather(const Contacts& contacts, BodyIndex i) {
    std::vector<ContactLoad>& all = tasks_[task_of(i)];
    loads_[i].first = static_cast<std::uint32_t>(all.size());
    for (const std::uint32_t side : index_.of(i)) {
      const auto& c = contacts.pairs()[side / 2];
      if (!c.touching) continue;
      const Vec2 on_b = c.force_on_b();
      if (side % 2 == 0)
        all.push_back({c.arm_a, -on_b, c.force.normal, c.b, side});
      else
        all.push_back({c.arm_b, on_b, c.force.normal, c.a, side});
    }
    loads_[i].last = static_cast<std::uint32_t>(all.size());
  }

  /// Accumulates the incremental bounds of a task in the order of its contacts in memory, and calls
  /// `candidate(i)` for each of its particles whose bound does not exclude that it breaks now.
  template <class Contacts, class Candidate>
  void check_incremental_bounds(const Particles& particles, const Contacts& contacts,
                                std::size_t task, std::size_t first, std::size_t last,
                                Candidate&& candidate)
    requires linear
  {
    begin_task(task);
    std::array<IncrementalBound, task_size> bounds;
    for (std::size_t i = first; i < last; ++i)
      bounds[i - first] = IncrementalBound(particles.body(static_cast<BodyIndex>(i)).rotation,
                                           tracked_contacts_[i]);
    // One of the two bodies is the task's, and a < b.
    const LoadSensitivity* const sensitivities = sensitivities_.data();
    contacts.for_each_touching_of(task, [&](const auto& c, std::size_t k) {
      const Vec2 on_b = c.force_on_b();
      if (c.a >= first) bounds[c.a - first].accumulate(sensitivities[2 * k], c.arm_a, on_b);
      if (c.b < last) bounds[c.b - first].accumulate(sensitivities[2 * k + 1], c.arm_b, on_b);
    });
    for (std::size_t i = first; i < last; ++i)
      if (!bounds[i - first].within_budget()) candidate(static_cast<BodyIndex>(i));
  }

  /// Contacts of particle i at the last `gather`.
  [[nodiscard]] std::size_t contact_count(BodyIndex i) const { return loads(i).size(); }
  /// Hash of the contact partners of i: changes when they do.
  [[nodiscard]] std::uint64_t partners(const Particles& particles, BodyIndex i) const {
    std::uint64_t sum = 0;
    for (const ContactLoad& load : loads(i)) sum += splitmix64(particles.ancestry(load.partner).id);
    return sum;
  }

  /// Element stresses of particle i under `scale` times the gathered loads, in its own frame. The
  /// reference is valid until the next call.
  const ElementStress& evaluate(const Particles& particles, BodyIndex i, double scale = 1) {
    const InfluenceOperator& op = influence(particles, i);
    const Rotation& rotation = particles.body(i).rotation;
    balanced_.clear();
    for (const ContactLoad& load : loads(i)) {
      require_finite("sum of a contact's arm and force",
                     load.arm.x() + load.arm.y() + load.force.x() + load.force.y());
      balanced_.push_back({op.mesh().nearest_boundary_point(rotation.inverse_times(load.arm)),
                           rotation.inverse_times(load.force), load.normal_force});
    }
    operators_.model().support.apply_reactions(std::span<BoundaryLoad>(balanced_), op);
    stress_.reset(op.mesh().size());
    for (const BoundaryLoad& load : balanced_) op.add_stress(load.at, scale * load.force, stress_);
    return stress_;
  }

  /// Whether the bound on the change of stress of particle i since its last `screen` excludes that
  /// it breaks now. If so, its incremental bound starts from here.
  [[nodiscard]] bool bound_excludes_failure(const Particles& particles, BodyIndex i)
    requires linear
  {
    StressChangeBound::Sensitivities sensitivities;
    const bool holds = bounds_[i].within_limit(loads(i), particles.body(i).rotation, sensitivities);
    if (holds)
      track(i, sensitivities);
    else
      tracked_contacts_[i] = IncrementalBound::untracked;
    return holds;
  }
  /// Starts the incremental bound of particle i, which has no contacts.
  void track_without_contacts(BodyIndex i)
    requires linear
  {
    track(i, {});
  }

  /// Evaluates particle i in single precision. False: a trigger that needs `needed(elements)`
  /// failed elements does not fire, nor under loads close to these; true: it may fire, and
  /// `evaluate` decides. Threads may call it concurrently, each for other particles and with a
  /// workspace of its own; `evict_operators` must not run meanwhile.
  template <class Needed>
  [[nodiscard]] bool screen(const Particles& particles, BodyIndex i, double scale,
                            const Needed& needed, StressWorkspace& work)
    requires linear
  {
    const InfluenceOperatorF32& op = operators_.single_precision(particles, i);
    const Rotation& rotation = particles.body(i).rotation;
    work.balanced.clear();
    work.places.clear();
    for (const ContactLoad& load : loads(i)) {
      const LocatedPoint place = op.locator().nearest(rotation.inverse_times(load.arm));
      work.balanced.push_back({place.at, rotation.inverse_times(load.force), load.normal_force});
      work.places.push_back(place);
    }
    op.find_stress(work.balanced, scale, work.stress);
    const std::size_t needed_now = needed(op.elements());
    const ScreeningResult result = work.screening(work.stress, needed_now);
    const bool may = result.possible >= needed_now;
    if (may)
      bounds_[i].clear();
    else
      bounds_[i].reset(loads(i), work.balanced, work.places, rotation, op,
                       result.stress_margin / scale);
    (void)bound_excludes_failure(particles, i);
    return may;
  }
  void evict_operators() { operators_.evict(); }

  /// The operator of particle i, built on first use; valid until the next call.
  const InfluenceOperator& influence(const Particles& particles, BodyIndex i) {
    return operators_.exact(particles, i);
  }

  /// Discards all data of particle i: another particle has this index now.
  void forget(BodyIndex i) {
    operators_.forget(i);
    if (i < bounds_.size()) bounds_[i].clear();
    if (i < tracked_contacts_.size()) tracked_contacts_[i] = IncrementalBound::untracked;
  }

  [[nodiscard]] OperatorCache<StressPart>& operators() { return operators_; }
  /// Memory held by the operators [bytes].
  [[nodiscard]] std::size_t bytes() const { return operators_.bytes(); }

 private:
  [[nodiscard]] std::span<const ContactLoad> loads(BodyIndex i) const {
    const ContactLoad* const all = tasks_[task_of(i)].data();
    return {all + loads_[i].first, all + loads_[i].last};
  }

  // Weights move with their pairs. They refer to one particle of a pair, whatever the other is; a
  // particle that lost a pair is found by its number of contacts.
  template <class Contacts>
  void move_sensitivities(const Contacts& contacts) {
    if (revision_ == contacts.revision()) return;
    const bool follows = revision_ == contacts.previous_revision();
    next_sensitivities_.assign(2 * contacts.pairs().size(), {});
    for (std::size_t k = 0; follows && k < contacts.pairs().size(); ++k) {
      const std::size_t earlier = contacts.previous_index(k);
      if (earlier == Contacts::not_present) continue;
      next_sensitivities_[2 * k] = sensitivities_[2 * earlier];
      next_sensitivities_[2 * k + 1] = sensitivities_[2 * earlier + 1];
    }
    std::swap(sensitivities_, next_sensitivities_);
    if (!follows)
      std::fill(tracked_contacts_.begin(), tracked_contacts_.end(), IncrementalBound::untracked);
  }

  // Weights for each load of particle i, NaN for its pairs that do not touch.
  void track(BodyIndex i, std::span<const LoadSensitivity> sensitivities) {
    const std::span<const ContactLoad> own = loads(i);
    for (const std::uint32_t side : index_.of(i)) sensitivities_[side] = {};
    for (std::size_t c = 0; c < own.size(); ++c) {
      const std::uint32_t side = own[c].side;
      sensitivities_[side] = side % 2 == 0 ? sensitivities[c].opposite() : sensitivities[c];
    }
    tracked_contacts_[i] = static_cast<std::uint32_t>(own.size());
  }

  struct Range {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
  };

  OperatorCache<StressPart> operators_;
  std::vector<StressChangeBound> bounds_;
  // For the pairs of the present revision.
  PairIndex index_;
  std::uint64_t revision_ = 0;
  std::vector<LoadSensitivity> sensitivities_;       // of each side; on side a for the force on b
  std::vector<LoadSensitivity> next_sensitivities_;  // of the next revision
  std::vector<std::uint32_t>
      tracked_contacts_;  // number of contacts with weights, of each particle
  // Loads of each task, in the laboratory frame.
  std::vector<std::vector<ContactLoad>> tasks_;
  std::vector<Range> loads_;  // of each particle, within its task
  std::vector<BoundaryLoad> balanced_;
  ElementStress stress_;
};

}  // namespace riprap
