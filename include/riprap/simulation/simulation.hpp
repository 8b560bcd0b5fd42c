// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The simulation: particles, contacts and stress under one model, advanced step by step.

#include <cmath>
#include <concepts>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <riprap/contact/contact_list.hpp>
#include <riprap/core/execution/concepts.hpp>
#include <riprap/dynamics/boundary/domain_of.hpp>
#include <riprap/particle/assembly.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/particle/smallest_mass.hpp>
#include <riprap/simulation/body_changes.hpp>
#include <riprap/simulation/body_settings.hpp>
#include <riprap/simulation/body_step.hpp>
#include <riprap/simulation/bonding.hpp>
#include <riprap/simulation/break_event.hpp>
#include <riprap/simulation/breakage_stage.hpp>
#include <riprap/simulation/breaking.hpp>
#include <riprap/simulation/external_loads.hpp>
#include <riprap/simulation/model.hpp>
#include <riprap/simulation/observer.hpp>
#include <riprap/simulation/settings.hpp>
#include <riprap/simulation/setup.hpp>
#include <riprap/simulation/stress_query.hpp>

namespace riprap {

/// A running simulation, composed at compile time from the policies of a Model:
///
///     Simulation sim{Model{}.criterion(MohrCoulomb{}), random_assembly({.seed = 1}), Rock{}};
///     for (int i = 0; i < 1000; ++i) sim.step();
///
/// Moved, not copied: operators are large.
template <class ModelType>
class Simulation : public BodyChanges<Simulation<ModelType>>,
                   public Bonding<Simulation<ModelType>>,
                   public Breaking<Simulation<ModelType>>,
                   public Settings<Simulation<ModelType>, ModelType>,
                   public StressQueries<Simulation<ModelType>> {
 public:
  using Domain = DomainOf<decltype(ModelType::motion_model.boundary)>;
  using BondLaw = decltype(ModelType::contact_model.bond_law);
  using Contacts = ContactList<
      decltype(ModelType::contact_model.broad_phase),
      decltype(ModelType::contact_model.narrow_phase), decltype(ModelType::contact_model.law),
      Domain, decltype(ModelType::acceleration_model.neighbour_list),
      decltype(ModelType::acceleration_model.detection), PairsWithoutContact<BondLaw, Domain>>;
  static constexpr bool bonded = makes_bonds<BondLaw>;
  static constexpr bool breakable = !decltype(ModelType::breakage_model)::never_fails;
  /// Whether a step may evaluate finite elements.
  static constexpr bool needs_elements =
      breakable && riprap::needs_elements<decltype(ModelType::breakage_model)>;

  /// One rock or a list. Throws InvalidInput if the model, the assembly or a rock breaks a rule.
  Simulation(ModelType model, const Assembly& assembly, const Rocks& rocks)
      : model_(validated(std::move(model), assembly, rocks)), motion_(model_.motion_model),
        rocks_(rocks), particles_(assembly.thickness, rocks.densities()),
        contacts_(model_.contact_model.broad_phase, model_.contact_model.narrow_phase,
                  model_.contact_model.law),
        bonds_(model_.contact_model.bond_law), breakage_(model_) {
    mean_area_ = add_particles(assembly, particles_);
    if constexpr (requires { boundary().enclose(assembly, particles_); })
      boundary().enclose(assembly, particles_);
    if constexpr (Domain::periodic) contacts_.set_domain(boundary().domain());
    bonds_.begin(assembly, particles_, contacts_.domain());
    if constexpr (bonded && breakable) breakage_.piece_limit.count_cells(particles_);
    bonds_.exclude(contacts_);
    choose_time_step();
    contacts_.update(particles_, 0, model_.execution_policy);
    try {
      contacts_.check_overlaps(particles_);
    } catch (const SimulationError& error) {
      throw InvalidInput(error.what());
    }
  }

  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;
  Simulation(Simulation&&) = default;
  Simulation& operator=(Simulation&&) = default;

  /// One time step. Throws SimulationError, naming the particle, if its state is no longer finite,
  /// if the step takes it past others or into another, or if it breaks into pieces without end.
  template <class... Observers>
  void step(Observers&&... observers) {
    (hooks::check_step_observer<std::remove_cvref_t<Observers>, Simulation>(), ...);
    const auto on_phase_end = hooks::phase_timer(observers...);
    on_phase_end(StepPhase::other);
    boundary().drive(particles_.bodies(), time_step_);
    if constexpr (Domain::periodic) contacts_.set_domain(boundary().domain());
    advance_bodies();
    on_phase_end(StepPhase::integration);
    (hooks::before_forces(observers, *this), ...);
    if constexpr (Domain::periodic) {
      boundary().drift(time_step_);
      contacts_.set_domain(boundary().domain());
    }
    on_phase_end(StepPhase::other);
    bonds_.update(particles_, contacts_, {steps_ + 1, time_}, model_.execution_policy,
                  breakage_active_);
    contacts_.update(particles_, time_step_, model_.execution_policy, on_phase_end);
    contacts_.check_overlaps(particles_);
    this->tell_bond_breaks(observers...);
    (hooks::after_forces(observers, *this), ...);
    on_phase_end(StepPhase::other);
    kick_bodies_again();
    on_phase_end(StepPhase::integration);
    ++steps_;
    if constexpr (breakable)
      if (breakage_active_ && steps_ % model_.breakage_model.check_every == 0)
        this->break_particles(on_phase_end, observers...);
    (hooks::after_step(observers, *this), ...);
  }

  /// As it was given; for what experiments change see `boundary()`, `contact_law()` and the like.
  [[nodiscard]] const ModelType& model() const { return model_; }
  [[nodiscard]] const Rocks& rocks() const { return rocks_; }
  using StressQueries<Simulation>::rock;  // the first one, and that of particle i
  [[nodiscard]] const Particles& particles() const { return particles_; }
  [[nodiscard]] const Contacts& contacts() const { return contacts_; }
  [[nodiscard]] std::uint64_t steps() const { return steps_; }
  [[nodiscard]] double time_step() const { return time_step_; }  ///< [s]
  [[nodiscard]] double time() const { return time_; }            ///< [s]
  [[nodiscard]] BodyWork work() const { return total_work(work_, image_work_, other_work_); }
  /// Force [N] of all contacts on body i, a wall or any other, and their moment about its centroid
  /// c [N m]; about a point p: moment + cross(c - p, force). Zero moment for a platen.
  [[nodiscard]] const Wrench& force_on(BodyIndex i) const {
    require_body(particles_, i);
    return particles_.body(i).contact;
  }
  [[nodiscard]] const std::vector<BreakEvent>& breaks() const { return breaks_; }
  /// Mean area of the intact particles at the start, platens and prescribed bodies left out [m^2],
  /// and the mass of the smallest free one [kg].
  [[nodiscard]] double mean_area() const { return mean_area_; }
  [[nodiscard]] double smallest_mass() const { return smallest_mass_; }
  /// Memory held by influence operators [bytes].
  [[nodiscard]] std::size_t operator_bytes() const { return breakage_.operator_bytes(); }

  // What an experiment may change between steps, beside BodyChanges, Bonding and Settings.

  [[nodiscard]] auto& boundary() { return motion_.boundary; }
  [[nodiscard]] const auto& boundary() const { return motion_.boundary; }
  [[nodiscard]] auto& contact_law() { return contacts_.law(); }
  [[nodiscard]] auto& damping() { return motion_.damping; }

  /// What a simulation of the same model and rock needs to go on; written, `restored` must follow.
  static void for_each_field(auto& self, auto&& visit) {
    visit("steps", self.steps_);
    visit("time", self.time_);
    visit("time_step", self.time_step_);
    visit("smallest_mass", self.smallest_mass_);
    visit("mean_area", self.mean_area_);
    visit("breakage_active", self.breakage_active_);
    visit("work", self.work_);
    visit("image_work", self.image_work_);
    visit("other_work", self.other_work_);
    visit("motion", self.motion_);
    visit("particles", self.particles_);
    visit("contacts", self.contacts_);
    visit("breakage", self.breakage_);
    visit("loads", self.loads_);
    visit("breaks", self.breaks_);
    if constexpr (bonded) visit("bonds", self.bonds_);
  }
  void restored() {
    bonds_.restore(particles_, contacts_);
    contacts_.restore(particles_);
    breakage_.restart(model_);
  }

 private:
  friend class BodyChanges<Simulation>;
  friend class Bonding<Simulation>;
  friend class Breaking<Simulation>;
  friend class Settings<Simulation, ModelType>;
  friend class StressQueries<Simulation>;

  [[nodiscard]] auto stress_query() const {
    using Forces = decltype(this->interactions());
    return StressQuery<ModelType, Forces>{model_, rocks_, particles_, this->interactions(),
                                          breakage_};
  }

  [[nodiscard]] auto body_step() {
    return BodyStep(motion_, contacts_.domain(), time_step_, loads_.all(), bonds_.wrenches());
  }

  // Forces of the present poses move the bodies to the next ones.
  void advance_bodies() {
    const auto step = body_step();
    step_bodies([&](std::size_t task, BodyIndex first, BodyIndex last) {
      add_image_work(task, first, last, step.first_kick_time());
      step.advance(particles_, first, last, work_);
      contacts_.record_motion(particles_, task, first, last);
    });
    time_ += time_step_;
  }

  // The second kick, for integrators that have one.
  void kick_bodies_again() {
    if constexpr (decltype(body_step())::has_second_kick) {
      const auto step = body_step();
      step_bodies([&](std::size_t task, BodyIndex first, BodyIndex last) {
        add_image_work(task, first, last, step.second_kick_time());
        step.second_kick(particles_, first, last, work_);
      });
    }
  }

  void add_image_work(std::size_t task, BodyIndex first, BodyIndex last, double seconds) {
    contacts_.add_image_work(task, seconds, image_work_[task]);
    bonds_.add_image_work(first, last, contacts_.domain(), seconds, image_work_[task]);
  }

  // Calls `step(task, first, last)` for every task.
  template <class Step>
  void step_bodies(Step&& step) {
    work_.resize(particles_.size());
    image_work_.resize(task_count(particles_.size()));
    for_each_task(model_.execution_policy, particles_.size(),
                  [&](std::size_t task, std::size_t first, std::size_t last) {
                    step(task, static_cast<BodyIndex>(first), static_cast<BodyIndex>(last));
                  });
  }

  void choose_time_step() {
    smallest_mass_ = smallest_intact_mass(particles_, smallest_mass_);
    time_step_ = stable_time_step();
  }
  // By the rule, for the smallest intact mass.
  [[nodiscard]] double stable_time_step() const {
    const double stiffness =
        contacts_.law().peak_stiffness() + bonds_.stiffness(particles_, smallest_mass_);
    return model_.motion_model.time_step.time_step(smallest_mass_, stiffness);
  }

  ModelType model_;                           // as it was given
  decltype(ModelType::motion_model) motion_;  // as experiments have changed it
  Rocks rocks_;
  Particles particles_;
  Contacts contacts_;
  ExternalLoads loads_;
  [[no_unique_address]] BondStage<BondLaw, Domain> bonds_;
  [[no_unique_address]] BreakageStage<ModelType> breakage_;
  double smallest_mass_ = 0;
  double mean_area_ = 0;
  double time_step_ = 0;
  double time_ = 0;
  std::uint64_t steps_ = 0;
  bool breakage_active_ = true;
  std::vector<BodyWork> work_;        // on each body; the left piece goes on with its parent's
  std::vector<ExactSum> image_work_;  // of the tasks
  BodyWork other_work_;               // of bodies added and removed, and on those removed
  std::vector<BreakEvent> breaks_;
};

}  // namespace riprap
