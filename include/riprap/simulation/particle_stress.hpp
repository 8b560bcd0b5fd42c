#pragma once
/// @file
/// Contact forces to element stresses, for every particle of a simulation.

#include <cstdint>
#include <span>
#include <vector>

#include <riprap/core/hash.hpp>
#include <riprap/material/rock.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/stress/boundary_load.hpp>
#include <riprap/stress/element_stress.hpp>
#include <riprap/stress/influence_operator.hpp>

namespace riprap {

/// Keeps one influence operator per particle, built when first asked for, and the boundary loads of
/// all particles as of the last `gather`.
template <class StressPart>
class ParticleStress {
 public:
  ParticleStress(StressPart model, const Rock& rock) : model_(std::move(model)), rock_(rock) {}

  /// Sorts the contact forces by particle and turns them into body frames.
  template <class Contacts>
  void gather(const Particles& particles, const Contacts& contacts) {
    starts_.assign(particles.size() + 1, 0);
    partners_.assign(particles.size(), 0);
    contacts.for_each_touching([&](const auto& c) {
      ++starts_[c.a + 1];
      ++starts_[c.b + 1];
      partners_[c.a] += spread_bits(particles.ancestry(c.b).id);
      partners_[c.b] += spread_bits(particles.ancestry(c.a).id);
    });
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    loads_.resize(starts_.back());
    filled_.assign(starts_.begin(), starts_.end() - 1);
    contacts.for_each_touching([&](const auto& c) {
      const Vec2 on_b = c.force_on_b();
      loads_[filled_[c.a]++] = {c.arm_a, -on_b, c.force.normal};
      loads_[filled_[c.b]++] = {c.arm_b, on_b, c.force.normal};
    });
  }

  /// Contacts of particle i at the last `gather`.
  [[nodiscard]] std::size_t contact_count(BodyIndex i) const { return starts_[i + 1] - starts_[i]; }
  /// A number that stays the same as long as the contact partners of i do.
  [[nodiscard]] std::uint64_t partners(BodyIndex i) const { return partners_[i]; }

  /// Element stresses of particle i under `scale` times the gathered loads, in its own frame. The
  /// reference is good until the next call.
  const ElementStress& evaluate(const Particles& particles, BodyIndex i, double scale = 1) {
    const InfluenceOperator& op = influence(particles, i);
    const Rotation& rotation = particles.body(i).rotation;
    settled_.clear();
    for (std::uint32_t k = starts_[i]; k < starts_[i + 1]; ++k)
      settled_.push_back({op.mesh().nearest_boundary_point(rotation.inverse_times(loads_[k].arm)),
                          rotation.inverse_times(loads_[k].force), loads_[k].normal_force});
    model_.support.settle(std::span<BoundaryLoad>(settled_), op);
    stress_.reset(op.mesh().size());
    for (const BoundaryLoad& load : settled_) op.add_stress(load.at, scale * load.force, stress_);
    return stress_;
  }

  /// The operator of particle i, built now if it was not there.
  const InfluenceOperator& influence(const Particles& particles, BodyIndex i) {
    if (operators_.size() < particles.size()) operators_.resize(particles.size());
    if (operators_[i].empty())
      operators_[i] = InfluenceOperator(model_.mesher(particles.local_ring(i)), model_.element,
                                        model_.plane_state, rock_, particles.thickness(),
                                        decltype(model_.support)::needs_flexibility);
    return operators_[i];
  }

  /// Another particle lives at i now.
  void forget(BodyIndex i) {
    if (i < operators_.size()) operators_[i] = {};
  }

  /// Memory held by the operators [bytes].
  [[nodiscard]] std::size_t bytes() const {
    std::size_t sum = 0;
    for (const InfluenceOperator& op : operators_) sum += op.bytes();
    return sum;
  }

 private:
  // In laboratory axes: most gathers are cheap because turning is left to `evaluate`.
  struct Load {
    Vec2 arm{0, 0};
    Vec2 force{0, 0};
    double normal_force = 0;
  };

  StressPart model_;
  Rock rock_;
  std::vector<InfluenceOperator> operators_;
  std::vector<std::uint32_t> starts_{0};
  std::vector<std::uint32_t> filled_;
  std::vector<std::uint64_t> partners_;
  std::vector<Load> loads_;
  std::vector<BoundaryLoad> settled_;
  ElementStress stress_;
};

}  // namespace riprap
