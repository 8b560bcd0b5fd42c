#pragma once
/// @file
/// The simulation: particles, contacts and stress under one model, advanced step by step.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <riprap/breakage/crack.hpp>
#include <riprap/contact/contact_list.hpp>
#include <riprap/particle/assembly.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/simulation/break_event.hpp>
#include <riprap/simulation/model.hpp>
#include <riprap/simulation/observer.hpp>
#include <riprap/simulation/particle_stress.hpp>

namespace riprap {

/// Energy that has passed through the bodies since the start [J]; contacts book their own.
struct BodyWork {
  double boundary = 0;    ///< done by driven bodies on the rest
  double body_force = 0;  ///< done by the uniform body force
  double damping = 0;     ///< taken out by damping
};

/// A running simulation, composed at compile time from the policies of a Model:
///
///     Simulation sim{Model{}.criterion(MohrCoulomb{}), random_assembly({.seed = 1}), Rock{}};
///     for (int i = 0; i < 1000; ++i) sim.step();
///
/// Not copied (operators are large); moved freely.
template <class ModelType>
class Simulation {
 public:
  using Contacts = ContactList<decltype(ModelType::contact_model.broad_phase),
                               decltype(ModelType::contact_model.narrow_phase),
                               decltype(ModelType::contact_model.law)>;
  static constexpr bool breakable = !decltype(ModelType::breakage_model)::never_fails;

  /// Throws InvalidInput if the model, the assembly or the rock breaks a rule.
  Simulation(ModelType model, const Assembly& assembly, const Rock& rock)
      : model_(validated(std::move(model), assembly, rock)),
        rock_(rock),
        particles_(assembly.thickness, rock.density),
        contacts_(model_.contact_model.broad_phase, model_.contact_model.narrow_phase,
                  model_.contact_model.law),
        stress_(model_.stress_model, rock) {
    double total_area = 0;
    for (const PlacedParticle& placed : assembly.particles) {
      const BodyIndex i = particles_.add(placed.polygon, placed.motion);
      Body& body = particles_.body(i);
      body.velocity = placed.velocity;
      body.angular_velocity = placed.angular_velocity;
      total_area += particles_.shape(i).area;
      if (body.is_free()) smallest_mass_ = std::min(smallest_mass_, body.mass);
    }
    mean_area_ = total_area / static_cast<double>(particles_.size());
    if (smallest_mass_ < std::numeric_limits<double>::infinity())
      time_step_ = model_.motion_model.time_step.time_step(
          smallest_mass_, model_.contact_model.law.peak_stiffness());
    refusals_.resize(particles_.size());
    contacts_.update(particles_, 0);
  }

  /// One time step. Throws SimulationError, naming the particle, if a position is no longer finite.
  template <class... Observers>
  void step(Observers&... observers) {
    model_.motion_model.boundary.drive(particles_.bodies(), time_step_);
    advance_bodies();
    (hooks::before_forces(observers, *this), ...);
    contacts_.update(particles_, time_step_);
    (hooks::after_forces(observers, *this), ...);
    finish_bodies();
    ++steps_;
    if constexpr (breakable)
      if (breakage_active_ && steps_ % model_.breakage_model.check_every == 0)
        break_particles(observers...);
    if (steps_ % 1024 == 0) check_finite();
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
  /// Mean area of the intact particles [m^2], and the mass of the smallest free one [kg].
  [[nodiscard]] double mean_area() const { return mean_area_; }
  [[nodiscard]] double smallest_mass() const { return smallest_mass_; }
  /// Memory held by influence operators [bytes].
  [[nodiscard]] std::size_t operator_bytes() const { return stress_.bytes(); }

  // What an experiment may change between steps.

  /// Bodies may be given velocities or other motions; masses and poses are the simulation's own.
  [[nodiscard]] Body& body(BodyIndex i) { return particles_.body(i); }
  [[nodiscard]] auto& boundary() { return model_.motion_model.boundary; }
  [[nodiscard]] auto& contact_law() { return contacts_.law(); }
  [[nodiscard]] auto& damping() { return model_.motion_model.damping; }
  void set_breakage(bool active) { breakage_active_ = active; }
  /// Acceleration of the uniform body force on free bodies [m/s^2].
  void set_body_force(const Vec2& acceleration) { body_force_ = acceleration; }
  /// Shortens the time step [s], for tests of accuracy.
  void set_time_step(double seconds) {
    require_positive("time step", seconds);
    time_step_ = seconds;
  }

  /// Evaluates particle i now: its element stresses, in its own frame, good until the next call.
  [[nodiscard]] const ElementStress& element_stress(BodyIndex i) const {
    stress_.gather(particles_, contacts_);
    return stress_.evaluate(particles_, i);
  }
  [[nodiscard]] const Mesh& mesh(BodyIndex i) const { return stress_.influence(particles_, i).mesh(); }

  /// Rat of every particle now (0 for driven ones), in the order of the bodies.
  [[nodiscard]] std::vector<double> failed_ratios() const {
    std::vector<double> ratios(particles_.size(), 0);
    if constexpr (breakable) {
      stress_.gather(particles_, contacts_);
      for (BodyIndex i = 0; i < particles_.size(); ++i)
        if (particles_.body(i).is_free())
          ratios[i] = tally_failures(model_.breakage_model.criterion,
                                     stress_.evaluate(particles_, i))
                          .ratio();
    }
    return ratios;
  }

 private:
  /// A refused cut and the partners it was refused under.
  struct Refusal {
    bool active = false;
    std::uint64_t partners = 0;
  };

  [[nodiscard]] static ModelType validated(ModelType model, const Assembly& assembly,
                                           const Rock& rock) {
    model.validate();
    assembly.validate();
    rock.validate();
    if (assembly.particles.empty()) throw InvalidInput("Assembly.particles is empty");
    return model;
  }

  [[nodiscard]] Wrench wrench(const Body& body, Wrench& damped) const {
    Wrench total{body.contact.force + body.mass * body_force_, body.contact.moment};
    damped = model_.motion_model.damping(body, total);
    total.force += damped.force;
    total.moment += damped.moment;
    return total;
  }

  // Forces of the present poses move the bodies to the next ones.
  void advance_bodies() {
    const double kick_time = integrator().needs_finish ? 0.5 * time_step_ : time_step_;
    for (BodyIndex i = 0; i < particles_.size(); ++i) {
      Body& body = particles_.body(i);
      const Body before = body;
      if (body.is_free()) {
        Wrench damped;
        const Wrench total = wrench(body, damped);
        integrator().advance(body, total, time_step_);
        book(before, body, damped, kick_time);
      } else {
        drift(body, time_step_);
        work_.boundary -= kick_time * (body.contact.force.dot(body.velocity) +
                                       body.contact.moment * body.angular_velocity);
      }
      particles_.update_ring(i);
    }
    time_ += time_step_;
  }

  // The second kick, for integrators that have one.
  void finish_bodies() {
    if constexpr (decltype(model_.motion_model.integrator)::needs_finish) {
      for (Body& body : particles_.bodies()) {
        if (body.is_free()) {
          const Body before = body;
          Wrench damped;
          const Wrench total = wrench(body, damped);
          integrator().finish(body, total, time_step_);
          book(before, body, damped, 0.5 * time_step_);
        } else {
          work_.boundary -= 0.5 * time_step_ *
                            (body.contact.force.dot(body.velocity) +
                             body.contact.moment * body.angular_velocity);
        }
      }
    }
  }

  void book(const Body& before, const Body& after, const Wrench& damped, double kick_time) {
    const Vec2 velocity = 0.5 * (before.velocity + after.velocity);
    const double spin = 0.5 * (before.angular_velocity + after.angular_velocity);
    work_.body_force += kick_time * after.mass * body_force_.dot(velocity);
    work_.damping -= kick_time * (damped.force.dot(velocity) + damped.moment * spin);
  }

  template <class... Observers>
  void break_particles(Observers&... observers) {
    stress_.gather(particles_, contacts_);
    broken_.clear();
    for (BodyIndex i = 0; i < particles_.size(); ++i) {
      if (!particles_.body(i).is_free() || stress_.contact_count(i) == 0) continue;
      Refusal& refusal = refusals_[i];
      if (refusal.active && refusal.partners == stress_.partners(i)) continue;
      refusal.active = false;
      const FailureTally tally =
          tally_failures(model_.breakage_model.criterion, stress_.evaluate(particles_, i));
      if (model_.breakage_model.trigger(tally)) broken_.push_back(i);
    }
    if (broken_.empty()) return;
    std::sort(broken_.begin(), broken_.end(), [&](BodyIndex i, BodyIndex j) {
      return particles_.ancestry(i).id < particles_.ancestry(j).id;
    });
    bool announced = false;
    for (const BodyIndex i : broken_) {
      const std::optional<Crack> crack =
          find_crack(model_.breakage_model, stress_.influence(particles_, i).mesh(),
                     stress_.evaluate(particles_, i), particles_.body(i), particles_.ring(i),
                     mean_area_);
      if (!crack) {
        refusals_[i] = {true, stress_.partners(i)};
        continue;
      }
      if (!std::exchange(announced, true))
        (hooks::before_splits(observers, *this), ...);
      split(i, *crack);
      (hooks::on_break(observers, *this, breaks_.back()), ...);
    }
    if (!announced) return;
    // Pieces meet their neighbours anew at the same poses; all other forces come out as they were.
    contacts_.update(particles_, 0);
    (hooks::after_splits(observers, *this), ...);
  }

  // The left piece takes the parent's place, the right one is new.
  void split(BodyIndex i, const Crack& crack) {
    const Body parent = particles_.body(i);
    const Ancestry ancestry = particles_.ancestry(i);
    const ConvexPolygon left{crack.pieces.left};
    const ConvexPolygon right{crack.pieces.right};
    particles_.replace(i, left, Motion::free, ancestry);
    const BodyIndex second = particles_.add(right, Motion::free, &ancestry);
    for (const BodyIndex piece : {i, second}) {
      Body& body = particles_.body(piece);
      model_.breakage_model.inheritance(parent, body);
      body.mass_scaling = model_.motion_model.time_step.mass_scaling(body.mass, smallest_mass_);
    }
    contacts_.divide(i, second,
                     [&](const Vec2& point) { return crack.line.left_distance(point) < 0; });
    stress_.forget(i);
    refusals_.resize(particles_.size());
    refusals_[i] = {};
    breaks_.push_back({.step = steps_,
                       .time = time_,
                       .particle = ancestry,
                       .tally = crack.tally,
                       .mode = crack.mode,
                       .line = crack.line,
                       .pieces = {particles_.ancestry(i).id, particles_.ancestry(second).id},
                       .areas = {particles_.shape(i).area, particles_.shape(second).area}});
  }

  void check_finite() const {
    for (BodyIndex i = 0; i < particles_.size(); ++i) {
      const Body& body = particles_.body(i);
      if (!body.position.allFinite() || !body.velocity.allFinite())
        throw SimulationError(particle_text(particles_.ancestry(i).id) +
                              ": position or velocity is no longer finite at step " +
                              std::to_string(steps_) + "; the time step is too long");
    }
  }

  [[nodiscard]] const auto& integrator() const { return model_.motion_model.integrator; }

  ModelType model_;
  Rock rock_;
  Particles particles_;
  Contacts contacts_;
  // Operators are built when first asked for, also by a const question.
  mutable ParticleStress<decltype(ModelType::stress_model)> stress_;
  double smallest_mass_ = std::numeric_limits<double>::infinity();
  double mean_area_ = 0;
  double time_step_ = 0;
  double time_ = 0;
  std::uint64_t steps_ = 0;
  Vec2 body_force_{0, 0};
  bool breakage_active_ = true;
  BodyWork work_;
  std::vector<Refusal> refusals_;
  std::vector<BodyIndex> broken_;
  std::vector<BreakEvent> breaks_;
};

}  // namespace riprap
