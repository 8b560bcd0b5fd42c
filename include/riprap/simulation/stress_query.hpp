// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Stresses of the particles of a simulation on demand, outside of a breakage pass.

#include <memory>
#include <vector>

#include <riprap/breakage/particle_failure.hpp>
#include <riprap/simulation/body_settings.hpp>
#include <riprap/simulation/breakage_stage.hpp>
#include <riprap/stress/contact_loads.hpp>
#include <riprap/stress/particle_stress.hpp>

namespace riprap {

/// Reads the state of a simulation and changes nothing: operators that are not in memory are built
/// and not kept.
/// @tparam Contacts a reference to a contact list, or Interactions
template <class ModelType, class Contacts>
class StressQuery {
 public:
  StressQuery(const ModelType& model, const Rocks& rocks, const Particles& particles,
              Contacts contacts, const BreakageStage<ModelType>& stage)
      : model_(model), rocks_(rocks), particles_(particles), contacts_(contacts), stage_(stage) {}

  /// Element stresses of particle i under its present contact forces, in its own frame, in the
  /// order of its sampling points.
  [[nodiscard]] ElementStress element_stress(BodyIndex i) const {
    return StressEvaluation{}(*find_operator(i), model_.stress_model.support,
                              particles_.body(i).rotation, loads_on(contacts_, i), 1);
  }
  [[nodiscard]] Mesh mesh(BodyIndex i) const { return find_operator(i)->mesh(); }
  [[nodiscard]] std::vector<SamplingPoint> sampling_points(BodyIndex i) const {
    const auto op = find_operator(i);
    const SamplingPoints all = op->sampling_points();
    std::vector<SamplingPoint> points;
    for (std::size_t k = 0; k < all.size(); ++k) points.push_back(all[k]);
    return points;
  }

  /// Share of the failed elements of every particle; 0 for driven and unloaded ones.
  [[nodiscard]] std::vector<double> failed_ratios() const {
    std::vector<double> ratios(particles_.size(), 0);
    ContactLoads loads;
    loads.begin(contacts_, particles_.size());
    StressEvaluation evaluate;
    for (BodyIndex i = 0; i < particles_.size(); ++i) {
      loads.gather(contacts_, i);
      if (!particles_.body(i).is_free() || loads.of(i).empty()) continue;
      const auto op = find_operator(i);
      ratios[i] = evaluate_particle(model_.breakage_model, model_.stress_model.support, *op,
                                    rock(i), particles_, i, loads.of(i), evaluate)
                      .failures.ratio();
    }
    return ratios;
  }

  /// Of particle i.
  [[nodiscard]] const Rock& rock(BodyIndex i) const { return rocks_[particles_.material(i)]; }

 private:
  // From memory or built anew.
  [[nodiscard]] std::shared_ptr<const InfluenceOperator> find_operator(BodyIndex i) const {
    if (const InfluenceOperator* known = stage_.find_operator(i))
      return {std::shared_ptr<const InfluenceOperator>(), known};  // does not own it
    return build_operator(model_.stress_model, rock(i), particles_, i);
  }

  const ModelType& model_;
  const Rocks& rocks_;
  const Particles& particles_;
  Contacts contacts_;
  const BreakageStage<ModelType>& stage_;
};

template <class M, class C>
StressQuery(const M&, const Rocks&, const Particles&, const C&, const BreakageStage<M>&)
    -> StressQuery<M, const C&>;

/// Base of a Simulation: what it says of the rock of its particles and the stress in them.
template <class Sim>
class StressQueries {
 public:
  /// Element stresses of particle i under its present contact forces, the points of the elements at
  /// which they are sampled, and the finite-element mesh, in the particle's own frame. Throw
  /// InvalidInput for a body that is not there.
  [[nodiscard]] ElementStress element_stress(BodyIndex i) const {
    return query(i).element_stress(i);
  }
  [[nodiscard]] std::vector<SamplingPoint> sampling_points(BodyIndex i) const {
    return query(i).sampling_points(i);
  }
  [[nodiscard]] Mesh mesh(BodyIndex i) const { return query(i).mesh(i); }
  /// The first rock, which is that of all particles where there is one only.
  [[nodiscard]] const Rock& rock() const { return sim().rocks().front(); }
  /// The rock of particle i.
  [[nodiscard]] const Rock& rock(BodyIndex i) const {
    require_body(sim().particles(), i);
    return sim().rocks()[sim().particles().material(i)];
  }
  /// Rat of every particle now (0 for driven and unloaded ones, and for all where neither trigger
  /// nor line fit needs elements), in the order of the bodies.
  [[nodiscard]] std::vector<double> failed_ratios() const {
    if constexpr (Sim::needs_elements)
      return sim().stress_query().failed_ratios();
    else
      return std::vector<double>(sim().particles().size(), 0);
  }

 private:
  friend Sim;
  StressQueries() = default;
  [[nodiscard]] const Sim& sim() const { return static_cast<const Sim&>(*this); }
  [[nodiscard]] auto query(BodyIndex i) const {
    require_body(sim().particles(), i);
    return sim().stress_query();
  }
};

}  // namespace riprap
