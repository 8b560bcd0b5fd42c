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
#include <riprap/simulation/body_step.hpp>
#include <riprap/simulation/break_event.hpp>
#include <riprap/simulation/breakage_stage.hpp>
#include <riprap/simulation/model.hpp>
#include <riprap/simulation/observer.hpp>
#include <riprap/simulation/replace_by_pieces.hpp>
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
class Simulation {
 public:
  using Domain = DomainOf<decltype(ModelType::motion_model.boundary)>;
  using Contacts = ContactList<decltype(ModelType::contact_model.broad_phase),
                               decltype(ModelType::contact_model.narrow_phase),
                               decltype(ModelType::contact_model.law), Domain,
                               decltype(ModelType::acceleration_model.neighbour_list),
                               decltype(ModelType::acceleration_model.detection)>;
  static constexpr bool breakable = !decltype(ModelType::breakage_model)::never_fails;

  /// Throws InvalidInput if the model, the assembly or the rock breaks a rule.
  Simulation(ModelType model, const Assembly& assembly, const Rock& rock)
      : model_(validated(std::move(model), assembly, rock)), rock_(rock),
        particles_(assembly.thickness, rock.density),
        contacts_(model_.contact_model.broad_phase, model_.contact_model.narrow_phase,
                  model_.contact_model.law),
        breakage_(model_) {
    mean_area_ = add_particles(assembly, particles_);
    choose_time_step();
    if constexpr (requires { boundary().enclose(assembly, particles_); })
      boundary().enclose(assembly, particles_);
    if constexpr (Domain::periodic) contacts_.set_domain(boundary().domain());
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
    contacts_.update(particles_, time_step_, model_.execution_policy, on_phase_end);
    contacts_.check_overlaps(particles_);
    (hooks::after_forces(observers, *this), ...);
    on_phase_end(StepPhase::other);
    kick_bodies_again();
    on_phase_end(StepPhase::integration);
    ++steps_;
    if constexpr (breakable)
      if (breakage_active_ && steps_ % model_.breakage_model.check_every == 0)
        break_particles(on_phase_end, observers...);
    (hooks::after_step(observers, *this), ...);
  }

  [[nodiscard]] const ModelType& model() const { return model_; }
  [[nodiscard]] const Rock& rock() const { return rock_; }
  [[nodiscard]] const Particles& particles() const { return particles_; }
  [[nodiscard]] const Contacts& contacts() const { return contacts_; }
  [[nodiscard]] std::uint64_t steps() const { return steps_; }
  [[nodiscard]] double time_step() const { return time_step_; }  ///< [s]
  [[nodiscard]] double time() const { return time_; }            ///< [s]
  [[nodiscard]] const BodyWork& work() const { return work_; }
  [[nodiscard]] const std::vector<BreakEvent>& breaks() const { return breaks_; }
  /// In the hook before_splits: which particles break, still whole, and how; in order of ids.
  [[nodiscard]] const BreakagePass::Cracks& cracks() const
    requires breakable
  {
    return breakage_.pass.cracks();
  }
  /// Mean area of the intact particles at the start, platens and prescribed bodies left out [m^2],
  /// and the mass of the smallest free one [kg].
  [[nodiscard]] double mean_area() const { return mean_area_; }
  [[nodiscard]] double smallest_mass() const { return smallest_mass_; }
  /// Memory held by influence operators [bytes].
  [[nodiscard]] std::size_t operator_bytes() const { return breakage_.operator_bytes(); }

  // What an experiment may change between steps.

  /// Gives body i a velocity [m/s] and a spin [rad/s]. Throws InvalidInput for a body that is not
  /// there and for numbers that are not finite.
  void set_velocity(BodyIndex i, const Vec2& velocity, double spin = 0) {
    require_body(i);
    if (!is_finite(velocity) || !std::isfinite(spin))
      throw InvalidInput(particle_text(particles_.ancestry(i).id) + ": velocity (" +
                         to_text(velocity.x()) + ", " + to_text(velocity.y()) + ") m/s, spin " +
                         to_text(spin) + " rad/s: must be finite");
    particles_.body(i).velocity = velocity;
    particles_.body(i).angular_velocity = spin;
  }
  /// Frees or holds body i. Chooses the time step anew, for a lighter body may be free now.
  void set_motion(BodyIndex i, Motion motion) {
    require_body(i);
    particles_.body(i).motion = motion;
    contacts_.invalidate();
    choose_time_step();
  }
  [[nodiscard]] auto& boundary() { return model_.motion_model.boundary; }
  [[nodiscard]] const auto& boundary() const { return model_.motion_model.boundary; }
  [[nodiscard]] auto& contact_law() { return contacts_.law(); }
  [[nodiscard]] auto& damping() { return model_.motion_model.damping; }
  void set_breakage(bool active) { breakage_active_ = active; }
  [[nodiscard]] bool breakage() const { return breakage_active_; }
  /// Sets the acceleration of the body force on free bodies [m/s^2], if it is uniform.
  void set_body_force(const Vec2& acceleration)
    requires std::same_as<decltype(ModelType::motion_model.body_force), UniformBodyForce>
  {
    const UniformBodyForce body_force{acceleration};
    body_force.validate();
    model_.motion_model.body_force = body_force;
  }
  [[nodiscard]] const auto& body_force() const { return model_.motion_model.body_force; }
  /// Replaces the time step [s] that the rule chose; stability is the caller's responsibility.
  void set_time_step(double seconds) {
    require_positive("time step", seconds);
    time_step_ = seconds;
  }

  /// Memory for influence operators [bytes], with an OperatorCache: results do not depend on it.
  void set_operator_budget(std::size_t bytes)
    requires requires(BreakageStage<ModelType>& stage) { stage.operators.set_budget(bytes); }
  {
    breakage_.operators.set_budget(bytes);
  }

  /// Element stresses of particle i under its present contact forces, the points of the elements at
  /// which they are sampled, and the finite-element mesh, in the particle's own frame.
  [[nodiscard]] ElementStress element_stress(BodyIndex i) const {
    return stress_query(i).element_stress(i);
  }
  [[nodiscard]] std::vector<SamplingPoint> sampling_points(BodyIndex i) const {
    return stress_query(i).sampling_points(i);
  }
  [[nodiscard]] Mesh mesh(BodyIndex i) const { return stress_query(i).mesh(i); }
  /// Rat of every particle now (0 for driven and unloaded ones), in the order of the bodies.
  [[nodiscard]] std::vector<double> failed_ratios() const {
    std::vector<double> ratios(particles_.size(), 0);
    if constexpr (breakable) ratios = stress_query().failed_ratios();
    return ratios;
  }

 private:
  void require_body(BodyIndex i) const {
    require(i < particles_.size(), "body", i, "must be in the simulation");
  }

  [[nodiscard]] StressQuery<ModelType, Contacts> stress_query() const {
    return {model_, rock_, particles_, contacts_, breakage_};
  }
  [[nodiscard]] StressQuery<ModelType, Contacts> stress_query(BodyIndex i) const {
    require_body(i);
    return stress_query();
  }

  [[nodiscard]] auto body_step() {
    return BodyStep(model_.motion_model, contacts_.domain(), time_step_);
  }

  // Forces of the present poses move the bodies to the next ones.
  void advance_bodies() {
    const auto step = body_step();
    work_.boundary += step.first_kick_time() * contacts_.image_power();
    step_bodies([&](std::size_t task, BodyIndex first, BodyIndex last) {
      const BodyWork work = step.advance(particles_, first, last);
      contacts_.record_motion(particles_, task, first, last);
      return work;
    });
    time_ += time_step_;
  }

  // The second kick, for integrators that have one.
  void kick_bodies_again() {
    if constexpr (decltype(body_step())::has_second_kick) {
      const auto step = body_step();
      work_.boundary += step.second_kick_time() * contacts_.image_power();
      step_bodies([&](std::size_t, BodyIndex first, BodyIndex last) {
        return step.second_kick(particles_, first, last);
      });
    }
  }

  // Books the work that `step(task, first, last)` returns, task by task.
  template <class Step>
  void step_bodies(Step&& step) {
    task_work_.resize(task_count(particles_.size()));
    for_each_task(model_.execution_policy, particles_.size(),
                  [&](std::size_t task, std::size_t first, std::size_t last) {
                    task_work_[task] =
                        step(task, static_cast<BodyIndex>(first), static_cast<BodyIndex>(last));
                  });
    for (const BodyWork& work : task_work_) work_ += work;
  }

  // All cracks are found before the first split, which changes the contacts that load the others.
  template <class OnPhaseEnd, class... Observers>
  void break_particles(OnPhaseEnd&& on_phase_end, Observers&... observers) {
    const BreakagePass::Cracks& cracks =
        breakage_.find_cracks(model_, rock_, mean_area_, particles_, contacts_, on_phase_end);
    if (cracks.empty()) return;
    const std::size_t first = breaks_.size();
    (hooks::before_splits(observers, *this), ...);
    for (const auto& [i, crack] : cracks) split(i, crack);
    // Contacts of the pieces at the same poses. All other forces stay the same, except those of
    // dashpots after a second kick, which has changed the velocities.
    contacts_.update(particles_, 0, model_.execution_policy);
    (hooks::after_splits(observers, *this), ...);
    for (std::size_t k = first; k < breaks_.size(); ++k)
      (hooks::on_break(observers, *this, breaks_[k]), ...);
    on_phase_end(StepPhase::splitting);
  }

  void split(BodyIndex i, const Crack& crack) {
    BreakEvent event{.step = steps_,
                     .time = time_,
                     .particle = particles_.ancestry(i),
                     .failures = crack.failures,
                     .mode = crack.mode,
                     .line = crack.line,
                     .crack_length = crack.length};
    const BodyIndex second = replace_by_pieces(model_, smallest_mass_, crack, i, particles_, event);
    const auto on_right = [&](const Vec2& x) { return crack.line.left_distance(x) < 0; };
    const auto on_dust = [&](const Vec2& x) { return crack.is_dust[on_right(x) ? 1 : 0]; };
    if (crack.leaves_dust())
      contacts_.cut_off(i, on_dust);
    else
      contacts_.divide(i, second, on_right);
    breakage_.forget(i);
    breaks_.push_back(event);
  }

  void choose_time_step() {
    smallest_mass_ = smallest_intact_mass(particles_, smallest_mass_);
    const double stiffness = contacts_.law().peak_stiffness();
    time_step_ = model_.motion_model.time_step.time_step(smallest_mass_, stiffness);
  }

  ModelType model_;
  Rock rock_;
  Particles particles_;
  Contacts contacts_;
  [[no_unique_address]] BreakageStage<ModelType> breakage_;
  double smallest_mass_ = 0;
  double mean_area_ = 0;
  double time_step_ = 0;
  double time_ = 0;
  std::uint64_t steps_ = 0;
  bool breakage_active_ = true;
  BodyWork work_;
  std::vector<BodyWork> task_work_;
  std::vector<BreakEvent> breaks_;
};

}  // namespace riprap
