// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// One time step of all bodies, and the work that is done on them.

#include <cmath>
#include <span>
#include <type_traits>

#include <riprap/core/errors.hpp>
#include <riprap/core/exact_sum.hpp>
#include <riprap/dynamics/integrator/concepts.hpp>
#include <riprap/particle/domain.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Energy that has passed through a body, or through all of them, since the start [J]; contacts
/// book their own.
struct BodyWork {
  double boundary = 0;    ///< done by driven bodies, or by a shrinking cell, on the rest
  double body_force = 0;  ///< done by the body force
  double damping = 0;     ///< taken out by damping
  double load = 0;        ///< done by external loads
  double added = 0;       ///< kinetic and stored, of bodies added less those removed

  BodyWork& operator+=(const BodyWork& o) {
    boundary += o.boundary;
    body_force += o.body_force;
    damping += o.damping;
    load += o.load;
    added += o.added;
    return *this;
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("boundary", self.boundary);
    visit("body_force", self.body_force);
    visit("damping", self.damping);
    visit("load", self.load);
    visit("added", self.added);
  }
};

/// The work of all bodies: exactly summed, so that their order and tasks do not enter.
/// @param by_cell work of a periodic cell, in parts; @param other on bodies no longer there
[[nodiscard]] inline BodyWork total_work(std::span<const BodyWork> bodies,
                                         std::span<const ExactSum> by_cell = {},
                                         const BodyWork& other = {}) {
  ExactSum boundary;
  ExactSum body_force;
  ExactSum damping;
  ExactSum load;
  const auto add = [&](const BodyWork& work) {
    boundary.add(work.boundary);
    body_force.add(work.body_force);
    damping.add(work.damping);
    load.add(work.load);
  };
  for (const BodyWork& work : bodies) add(work);
  add(other);
  for (const ExactSum& work : by_cell) boundary += work;
  return {boundary.value(), body_force.value(), damping.value(), load.value(), other.added};
}

/// Bodies that no bond joins.
struct NoBondForces {};

/// Moves free bodies by the integrator and driven ones at their velocity. Each kick's work is
/// booked with the velocities before and after it.
/// @tparam MotionPart offers `integrator`, `damping` and `body_force`
/// @tparam BondForces a range of the wrench of bonds on each body
template <class MotionPart, class Domain, class BondForces = NoBondForces>
class BodyStep {
 public:
  static constexpr bool has_second_kick = decltype(MotionPart::integrator)::has_second_kick;

  /// @param time_step [s]
  /// @param loads external ones, on the bodies from the first on; those without one have none
  BodyStep(const MotionPart& motion, const Domain& domain, double time_step,
           std::span<const Wrench> loads = {}, BondForces bonds = {})
      : motion_(motion), domain_(domain), time_step_(time_step), loads_(loads), bonds_(bonds) {}

  /// Time of the first and of the second kick [s].
  [[nodiscard]] double first_kick_time() const {
    return first_kick_fraction(motion_.integrator) * time_step_;
  }
  [[nodiscard]] double second_kick_time() const {
    return (1 - first_kick_fraction(motion_.integrator)) * time_step_;
  }

  /// Forces of the present poses move bodies `first` to `last` to the next ones. Adds the
  /// work done on body i to `work[i]`; throws SimulationError, naming the particle, if its state is
  /// no longer finite, or if a step takes it so far that contacts could be missed.
  void advance(Particles& particles, BodyIndex first, BodyIndex last,
               std::span<BodyWork> work) const {
    const double kick_time = first_kick_time();
    for (BodyIndex i = first; i < last; ++i) {
      Body& body = particles.body(i);
      if (body.is_free()) {
        kick_free(i, body, load_on(i), kick_time, work[i], [this](Body& b, const Wrench& w) {
          motion_.integrator.advance(b, w, time_step_);
        });
      } else {
        drift(body, time_step_);
        book_driven(i, body, kick_time, work[i]);
      }
      if (!is_finite(body)) throw_not_finite(particles, i);
    }
    // In a loop of its own: a body's new pose comes out of a long chain of operations, and rings
    // that wait for it leave no room for the next body's.
    bool leaps = false;
    for (BodyIndex i = first; i < last; ++i) {
      leaps |= leaps_over(particles, i);
      particles.update_ring(i);
    }
    if (leaps) throw_leap(particles, first, last);
  }

  /// The second kick of bodies `first` to `last`, for integrators that have one.
  void second_kick(Particles& particles, BodyIndex first, BodyIndex last,
                   std::span<BodyWork> work) const {
    const double kick_time = second_kick_time();
    for (BodyIndex i = first; i < last; ++i) {
      Body& body = particles.body(i);
      if (body.is_free())
        kick_free(i, body, load_on(i), kick_time, work[i], [this](Body& b, const Wrench& w) {
          motion_.integrator.second_kick(b, w, time_step_);
        });
      else
        book_driven(i, body, kick_time, work[i]);
    }
  }

 private:
  [[nodiscard]] const Wrench* load_on(BodyIndex i) const {
    return i < loads_.size() ? &loads_[i] : nullptr;
  }

  template <class Kick>
  void kick_free(BodyIndex i, Body& body, const Wrench* load, double kick_time, BodyWork& work,
                 Kick&& kick) const {
    const Vec2 velocity_before = body.velocity;
    const double spin_before = body.angular_velocity;
    const Vec2 acceleration = motion_.body_force(body);
    Wrench total = forces_on(i, body);
    total.add({body.mass * acceleration.x(), body.mass * acceleration.y()}, 0);
    if (load) total.add(load->force, load->moment);
    const Wrench damped = motion_.damping(seen_by_damping(body), total);
    total.add(damped.force, damped.moment);
    kick(body, total);
    const double x = 0.5 * (velocity_before.x() + body.velocity.x());
    const double y = 0.5 * (velocity_before.y() + body.velocity.y());
    const double spin = 0.5 * (spin_before + body.angular_velocity);
    work.body_force += kick_time * body.mass * (acceleration.x() * x + acceleration.y() * y);
    if (load)
      work.load += kick_time * (load->force.x() * x + load->force.y() * y + load->moment * spin);
    work.damping -=
        kick_time * (damped.force.x() * x + damped.force.y() * y + damped.moment * spin);
  }

  // Damping acts on the motion relative to a periodic cell's own, which is the same for all images.
  [[nodiscard]] decltype(auto) seen_by_damping(const Body& body) const {
    if constexpr (Domain::periodic) {
      Body seen = body;
      seen.velocity -= domain_.field(body.position - domain_.centre);
      return seen;
    } else {
      return (body);
    }
  }

  // Of contacts and bonds.
  [[nodiscard]] Wrench forces_on([[maybe_unused]] BodyIndex i, const Body& body) const {
    Wrench total = body.contact;
    if constexpr (!std::is_same_v<BondForces, NoBondForces>)
      total.add(bonds_[i].force, bonds_[i].moment);
    return total;
  }
  void book_driven(BodyIndex i, const Body& body, double kick_time, BodyWork& work) const {
    const Wrench total = forces_on(i, body);
    work.boundary -=
        kick_time * (total.force.dot(body.velocity) + total.moment * body.angular_velocity);
  }

  // Whether a vertex moves by more than half the circumradius: a contact may begin and end within
  // a step or two.
  [[nodiscard]] bool leaps_over(const Particles& particles, BodyIndex i) const {
    const Body& body = particles.body(i);
    const double reach = particles.shape(i).circumradius;
    const double spin = reach * body.angular_velocity;
    const double squared = body.velocity.dot(body.velocity) + spin * spin;
    return squared * (time_step_ * time_step_) > 0.25 * (reach * reach);
  }
  [[noreturn, gnu::cold]] void throw_leap(const Particles& particles, BodyIndex first,
                                          BodyIndex last) const {
    BodyIndex i = first;
    while (i + 1 < last && !leaps_over(particles, i)) ++i;
    const Body& body = particles.body(i);
    throw SimulationError(
        particle_text(particles.ancestry(i).id) + ": moves at " + to_text(body.velocity.norm()) +
        " m/s and " + to_text(body.angular_velocity) + " rad/s, in a time step of " +
        to_text(time_step_) + " s by more than half its circumradius of " +
        to_text(particles.shape(i).circumradius) + " m: contacts would be missed");
  }

  [[noreturn, gnu::cold]] static void throw_not_finite(const Particles& particles, BodyIndex i) {
    const Body& body = particles.body(i);
    throw SimulationError(particle_text(particles.ancestry(i).id) + ": position (" +
                          to_text(body.position.x()) + ", " + to_text(body.position.y()) +
                          ") m, spin " + to_text(body.angular_velocity) +
                          " rad/s: no longer finite");
  }

  [[nodiscard]] static bool is_finite(const Body& body) {
    // A sum is finite only if all its terms are.
    return std::isfinite(body.position.x() + body.position.y() + body.angular_velocity);
  }

  const MotionPart& motion_;
  [[no_unique_address]] Domain domain_;
  double time_step_;
  std::span<const Wrench> loads_;
  [[no_unique_address]] BondForces bonds_;
};

}  // namespace riprap
