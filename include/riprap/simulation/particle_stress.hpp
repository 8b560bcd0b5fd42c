#pragma once
/// @file
/// Contact forces to element stresses, for every particle of a simulation.

#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <riprap/breakage/failure_distance.hpp>
#include <riprap/core/execution/serial.hpp>
#include <riprap/core/hash.hpp>
#include <riprap/material/rock.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/simulation/operator_store.hpp>
#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/element_stress.hpp>
#include <riprap/stress/load_reference.hpp>
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
/// the loads under which each particle was last known not to break.
template <class StressPart>
class ParticleStress {
 public:
  /// Whether stress is linear in the contact loads, as the bound on its change needs it. Other
  /// supports choose anew which contacts they hold.
  static constexpr bool linear = std::same_as<decltype(StressPart::support), InertiaRelief>;

  ParticleStress(StressPart model, const Rock& rock) : operators_(std::move(model), rock) {}

  /// Sorts the contact forces by particle.
  template <class Contacts>
  void gather(const Particles& particles, const Contacts& contacts) {
    begin_gather(particles);
    for_each_task(Serial{}, particles.size(),
                  [&](std::size_t task, std::size_t first, std::size_t last) {
                    gather_task(contacts, task, first, last);
                  });
  }

  /// The same in parts, for those who go on with the loads of a task at once. `begin_gather` comes
  /// first; tasks, those of `for_each_task`, do not touch each other.
  void begin_gather(const Particles& particles) {
    operators_.begin_turn(particles.size());
    references_.resize(particles.size());
    tasks_.resize(task_count(particles.size()));
  }
  template <class Contacts>
  void gather_task(const Contacts& contacts, std::size_t task, std::size_t first,
                   std::size_t last) {
    TaskLoads& own = tasks_[task];
    own.starts.assign(last - first + 1, 0);
    // One of the two is the task's, and a is below b.
    contacts.for_each_touching_of(task, [&](const auto& c) {
      if (c.a >= first) ++own.starts[c.a - first + 1];
      if (c.b < last) ++own.starts[c.b - first + 1];
    });
    for (std::size_t i = 1; i < own.starts.size(); ++i) own.starts[i] += own.starts[i - 1];
    own.loads.resize(own.starts.back());
    own.filled.assign(own.starts.begin(), own.starts.end() - 1);
    contacts.for_each_touching_of(task, [&](const auto& c) {
      const Vec2 on_b = c.force_on_b();
      if (c.a >= first)
        own.loads[own.filled[c.a - first]++] = {c.arm_a, -on_b, c.force.normal, c.b};
      if (c.b < last) own.loads[own.filled[c.b - first]++] = {c.arm_b, on_b, c.force.normal, c.a};
    });
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
    for (const ContactLoad& load : loads(i))
      settled_.push_back({op.mesh().nearest_boundary_point(rotation.inverse_times(load.arm)),
                          rotation.inverse_times(load.force), load.normal_force});
    operators_.model().support.settle(std::span<BoundaryLoad>(settled_), op);
    stress_.reset(op.mesh().size());
    for (const BoundaryLoad& load : settled_) op.add_stress(load.at, scale * load.force, stress_);
    return stress_;
  }

  /// Whether the loads of particle i are so near to those of its last `may_break` that it cannot
  /// break now.
  [[nodiscard]] bool known_to_hold(const Particles& particles, BodyIndex i) const {
    return references_[i].holds(loads(i), particles.body(i).rotation);
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
  }

  [[nodiscard]] OperatorStore<StressPart>& operators() { return operators_; }
  /// Memory held by the operators [bytes].
  [[nodiscard]] std::size_t bytes() const { return operators_.bytes(); }

 private:
  [[nodiscard]] std::span<const ContactLoad> loads(BodyIndex i) const {
    const TaskLoads& task = tasks_[task_of(i)];
    const std::uint32_t* const start = task.starts.data() + i % task_size;
    return {task.loads.data() + start[0], task.loads.data() + start[1]};
  }

  // Of the particles of a task, one after the other. In laboratory axes: turning is left to those
  // who need it.
  struct TaskLoads {
    std::vector<std::uint32_t> starts{};
    std::vector<std::uint32_t> filled{};
    std::vector<ContactLoad> loads{};
  };

  OperatorStore<StressPart> operators_;
  std::vector<LoadReference> references_;
  std::vector<TaskLoads> tasks_;
  std::vector<BoundaryLoad> settled_;
  ElementStress stress_;
};

}  // namespace riprap
