#pragma once
/// @file
/// Contact forces to element stresses, for every particle of a simulation.

#include <concepts>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include <riprap/breakage/failure_distance.hpp>
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
    operators_.begin_turn(particles.size());
    references_.resize(particles.size());
    starts_.assign(particles.size() + 1, 0);
    contacts.for_each_touching([&](const auto& c) {
      ++starts_[c.a + 1];
      ++starts_[c.b + 1];
    });
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    loads_.resize(starts_.back());
    filled_.assign(starts_.begin(), starts_.end() - 1);
    contacts.for_each_touching([&](const auto& c) {
      const Vec2 on_b = c.force_on_b();
      loads_[filled_[c.a]++] = {c.arm_a, -on_b, c.force.normal, c.b};
      loads_[filled_[c.b]++] = {c.arm_b, on_b, c.force.normal, c.a};
    });
  }

  /// Contacts of particle i at the last `gather`.
  [[nodiscard]] std::size_t contact_count(BodyIndex i) const { return starts_[i + 1] - starts_[i]; }
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
    return {loads_.data() + starts_[i], loads_.data() + starts_[i + 1]};
  }

  OperatorStore<StressPart> operators_;
  std::vector<LoadReference> references_;
  std::vector<std::uint32_t> starts_{0};
  std::vector<std::uint32_t> filled_;
  // In laboratory axes: turning is left to those who need it.
  std::vector<ContactLoad> loads_;
  std::vector<BoundaryLoad> settled_;
  ElementStress stress_;
};

}  // namespace riprap
