// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Contact forces to element stresses, for every particle of a simulation.

#include <algorithm>
#include <array>
#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include <riprap/breakage/failure_distance.hpp>
#include <riprap/contact/pair_index.hpp>
#include <riprap/core/errors.hpp>
#include <riprap/core/execution/serial.hpp>
#include <riprap/core/hash.hpp>
#include <riprap/material/rock.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/simulation/operator_store.hpp>
#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/element_stress.hpp>
#include <riprap/stress/load_reference.hpp>
#include <riprap/stress/load_watch.hpp>
#include <riprap/stress/support/inertia_relief.hpp>

namespace riprap {

/// What one thread needs to find out whether a particle may break; kept for its memory.
struct StressWorkspace {
  FailureForecast forecast;
  std::vector<BoundaryLoad> settled{};
  std::vector<OutlinePoint> places{};
  CompactStress stress{};
};

/// Keeps the influence operators of all particles, the contact loads as of the last `gather`, and
/// the loads under which each particle was last known not to break. Particles are watched contact
/// by contact; only those who spend their budget are gathered and compared with those loads.
template <class StressPart>
class ParticleStress {
 public:
  /// Whether stress is linear in the contact loads, as the bound on its change needs it. Other
  /// supports choose anew which contacts they hold.
  static constexpr bool linear = std::same_as<decltype(StressPart::support), InertiaRelief>;

  ParticleStress(StressPart model, const Rock& rock) : operators_(std::move(model), rock) {}

  /// Finds the contact forces on every particle.
  template <class Contacts>
  void gather(const Particles& particles, const Contacts& contacts) {
    begin_gather(particles, contacts);
    for_each_task(Serial{}, particles.size(),
                  [&](std::size_t task, std::size_t first, std::size_t last) {
                    begin_task(task);
                    for (auto i = static_cast<BodyIndex>(first); i < last; ++i) gather(contacts, i);
                  });
  }

  /// The same for some, in tasks of `for_each_task` that do not touch each other. `begin_gather`
  /// comes first, then `begin_task` or `watch_task`.
  template <class Contacts>
  void begin_gather(const Particles& particles, const Contacts& contacts) {
    operators_.begin_turn(particles.size());
    if (numbering_ != contacts.numbering() || watched_.size() != particles.size()) {
      if constexpr (linear) renumber_prices(contacts);
      numbering_ = contacts.numbering();
      index_.build(contacts.pairs(), particles.size());
      watched_.resize(particles.size(), LoadWatch::none);
    }
    references_.resize(particles.size());
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

  /// Goes through the contacts of a task, as they lie in memory, and calls `suspect(i)` for each of
  /// its particles of which they do not show that it cannot break now. At 2 MPa 2 in 100 are left.
  template <class Contacts, class Suspect>
  void watch_task(const Particles& particles, const Contacts& contacts, std::size_t task,
                  std::size_t first, std::size_t last, Suspect&& suspect)
    requires linear
  {
    begin_task(task);
    std::array<LoadWatch, task_size> watches;
    for (std::size_t i = first; i < last; ++i)
      watches[i - first] =
          LoadWatch(particles.body(static_cast<BodyIndex>(i)).rotation, watched_[i]);
    // One of the two is the task's, and a is below b.
    const LoadPrice* const prices = prices_.data();
    contacts.for_each_touching_of(task, [&](const auto& c, std::size_t k) {
      const Vec2 on_b = c.force_on_b();
      if (c.a >= first) watches[c.a - first].meet(prices[2 * k], c.arm_a, on_b);
      if (c.b < last) watches[c.b - first].meet(prices[2 * k + 1], c.arm_b, on_b);
    });
    for (std::size_t i = first; i < last; ++i)
      if (!watches[i - first].holds()) suspect(static_cast<BodyIndex>(i));
  }

  /// Contacts of particle i at the last `gather`.
  [[nodiscard]] std::size_t contact_count(BodyIndex i) const { return loads(i).size(); }
  /// A number that stays the same as long as the contact partners of i do.
  [[nodiscard]] std::uint64_t partners(const Particles& particles, BodyIndex i) const {
    std::uint64_t sum = 0;
    for (const ContactLoad& load : loads(i))
      sum += spread_bits(particles.ancestry(load.partner).id);
    return sum;
  }

  /// Element stresses of particle i under `scale` times the gathered loads, in its own frame. The
  /// reference is good until the next call.
  const ElementStress& evaluate(const Particles& particles, BodyIndex i, double scale = 1) {
    const InfluenceOperator& op = influence(particles, i);
    const Rotation& rotation = particles.body(i).rotation;
    settled_.clear();
    for (const ContactLoad& load : loads(i)) {
      require_finite("sum of a contact's arm and force",
                     load.arm.x() + load.arm.y() + load.force.x() + load.force.y());
      settled_.push_back({op.mesh().nearest_boundary_point(rotation.inverse_times(load.arm)),
                          rotation.inverse_times(load.force), load.normal_force});
    }
    operators_.model().support.settle(std::span<BoundaryLoad>(settled_), op);
    stress_.reset(op.mesh().size());
    for (const BoundaryLoad& load : settled_) op.add_stress(load.at, scale * load.force, stress_);
    return stress_;
  }

  /// Whether the loads of particle i are so near to those of its last `may_break` that it cannot
  /// break now. If so, it is watched from here on.
  [[nodiscard]] bool known_to_hold(const Particles& particles, BodyIndex i)
    requires linear
  {
    LoadReference::Prices prices;
    const bool holds = references_[i].holds(loads(i), particles.body(i).rotation, prices);
    if (holds)
      watch(i, prices);
    else
      watched_[i] = LoadWatch::none;
    return holds;
  }
  /// Particle i, which has no contacts, is watched for the first to come.
  void watch_for_contacts(BodyIndex i)
    requires linear
  {
    watch(i, {});
  }

  /// Evaluates particle i in single precision. False: a trigger that needs `needed(elements)`
  /// failed elements does not fire, nor under loads that are near enough; true: it may, and
  /// `evaluate` decides. Threads may ask at once, each for other particles and with a workspace of
  /// its own; `trim_operators` belongs between.
  template <class Needed>
  [[nodiscard]] bool may_break(const Particles& particles, BodyIndex i, double scale,
                               const Needed& needed, StressWorkspace& work)
    requires linear
  {
    const CompactOperator& op = operators_.compact(particles, i);
    const Rotation& rotation = particles.body(i).rotation;
    work.settled.clear();
    work.places.clear();
    for (const ContactLoad& load : loads(i)) {
      const OutlinePoint place = op.outline().nearest(rotation.inverse_times(load.arm));
      work.settled.push_back({place.at, rotation.inverse_times(load.force), load.normal_force});
      work.places.push_back(place);
    }
    op.find_stress(work.settled, scale, work.stress);
    const std::size_t needed_now = needed(op.elements());
    const FailureOutlook outlook = work.forecast(work.stress, needed_now);
    const bool may = outlook.possible >= needed_now;
    if (may)
      references_[i].forget();
    else
      references_[i].renew(loads(i), work.settled, work.places, rotation, op,
                           outlook.harmless_change / scale);
    (void)known_to_hold(particles, i);
    return may;
  }
  void trim_operators() { operators_.trim(); }

  /// The operator of particle i, built now if it was not there; good until the next call.
  const InfluenceOperator& influence(const Particles& particles, BodyIndex i) {
    return operators_.exact(particles, i);
  }

  /// Another particle lives at i now.
  void forget(BodyIndex i) {
    operators_.forget(i);
    if (i < references_.size()) references_[i].forget();
    if (i < watched_.size()) watched_[i] = LoadWatch::none;
  }

  [[nodiscard]] OperatorStore<StressPart>& operators() { return operators_; }
  /// Memory held by the operators [bytes].
  [[nodiscard]] std::size_t bytes() const { return operators_.bytes(); }

 private:
  [[nodiscard]] std::span<const ContactLoad> loads(BodyIndex i) const {
    const ContactLoad* const all = tasks_[task_of(i)].data();
    return {all + loads_[i].first, all + loads_[i].last};
  }

  // Prices go with their pairs. They speak of places and forces on one particle, whoever is the
  // other; if a pair is no more, the particle misses a contact.
  template <class Contacts>
  void renumber_prices(const Contacts& contacts) {
    if (numbering_ == contacts.numbering()) return;
    const bool follows = numbering_ == contacts.earlier_numbering();
    next_prices_.assign(2 * contacts.pairs().size(), {});
    for (std::size_t k = 0; follows && k < contacts.pairs().size(); ++k) {
      const std::size_t earlier = contacts.earlier_place(k);
      if (earlier == Contacts::new_pair) continue;
      next_prices_[2 * k] = prices_[2 * earlier];
      next_prices_[2 * k + 1] = prices_[2 * earlier + 1];
    }
    std::swap(prices_, next_prices_);
    if (!follows) std::fill(watched_.begin(), watched_.end(), LoadWatch::none);
  }

  // A price for each load of particle i, and none for its pairs that do not touch.
  void watch(BodyIndex i, std::span<const LoadPrice> prices) {
    const std::span<const ContactLoad> own = loads(i);
    for (const std::uint32_t side : index_.of(i)) prices_[side] = {};
    for (std::size_t c = 0; c < own.size(); ++c) {
      const std::uint32_t side = own[c].side;
      prices_[side] = side % 2 == 0 ? prices[c].opposite() : prices[c];
    }
    watched_[i] = static_cast<std::uint32_t>(own.size());
  }

  struct Range {
    std::uint32_t first = 0;
    std::uint32_t last = 0;
  };

  OperatorStore<StressPart> operators_;
  std::vector<LoadReference> references_;
  // Of the pairs as they are numbered.
  PairIndex index_;
  std::uint64_t numbering_ = 0;
  std::vector<LoadPrice> prices_;       // side by side; on side a for the force on b
  std::vector<LoadPrice> next_prices_;  // when they are numbered anew
  std::vector<std::uint32_t> watched_;  // how many contacts of each particle have a price
  // Loads task by task, in laboratory axes: turning is left to those who need it.
  std::vector<std::vector<ContactLoad>> tasks_;
  std::vector<Range> loads_;  // of each particle, among those of its task
  std::vector<BoundaryLoad> settled_;
  ElementStress stress_;
};

}  // namespace riprap
