// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// What a program may do to bodies between steps: move, free, hold, load, add and remove them.

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <riprap/core/errors.hpp>
#include <riprap/geometry/convex_polygon.hpp>
#include <riprap/measurement/energy.hpp>
#include <riprap/particle/assembly.hpp>
#include <riprap/particle/particles.hpp>
#include <riprap/particle/smallest_mass.hpp>
#include <riprap/simulation/body_settings.hpp>

namespace riprap {

/// Base of a Simulation. All of these belong between steps.
template <class Sim>
class BodyChanges {
 public:
  /// Gives body i a velocity [m/s] and a spin [rad/s]. Throws InvalidInput for a body that is not
  /// there and for numbers that are not finite.
  void set_velocity(BodyIndex i, const Vec2& velocity, double spin = 0) {
    set_body_velocity(sim().particles_, i, velocity, spin);
  }
  /// The same with the velocity of its material point at `point` [m], about which it turns.
  void set_velocity_about(BodyIndex i, const Vec2& point, const Vec2& velocity, double spin) {
    set_body_velocity_about(sim().particles_, i, point, velocity, spin);
  }
  /// Frees or holds body i. Chooses the time step anew, for a lighter body may be free now. Throws
  /// InvalidInput where a bonded body would become a wall or a platen: the stress of a bond has its
  /// branch from centroid to centroid, and a wall's does not belong to the sample. `prescribed`
  /// clamps it.
  void set_motion(BodyIndex i, Motion motion) {
    require_body(sim().particles_, i);
    if constexpr (Sim::bonded) {
      const std::size_t bonds = sim().bonds().index().of(i).size();
      require(bonds == 0 || !is_wall(motion),
              particle_text(sim().particles_.ancestry(i).id) + ": its bonds",
              static_cast<double>(bonds),
              "must be none for a wall or a platen; Motion::prescribed holds it");
    }
    sim().particles_.body(i).motion = motion;
    sim().contacts_.invalidate();
    sim().choose_time_step();
  }

  /// Puts a force [N] and a moment about its centroid [N m] on the body with an id, in laboratory
  /// axes, until they are set anew; zeros take them away. They act while the body is free, and end
  /// when it breaks. Their work is `work().load`. Stress in the particle is found with the load
  /// spread over its mass, as a body force is, under InertiaRelief. Throws InvalidInput if there is
  /// no such body and for numbers that are not finite.
  void set_load(ParticleId id, const Vec2& force, double moment = 0) {
    const BodyIndex i = index_of(id);
    if (!is_finite(force) || !std::isfinite(moment))
      throw InvalidInput(particle_text(id) + ": load (" + to_text(force.x()) + ", " +
                         to_text(force.y()) + ") N, " + to_text(moment) + " N m: must be finite");
    sim().loads_.set(i, {force, moment});
  }
  [[nodiscard]] Wrench load_on(ParticleId id) const { return sim().loads_.of(index_of(id)); }

  /// Adds a body, at the highest index, and finds its contacts. Its energy, with that of the
  /// contacts, is booked in `work().added`. If it is free and lighter than all, the time step
  /// becomes that for its mass, unless it is smaller already. The mean area stays that of the
  /// start.
  /// @return its id, which no other body ever has
  /// Throws InvalidInput if a number is not finite, or if it overlaps another body by more than
  /// three quarters of the smaller one; then nothing has changed but for the id that is used up.
  ParticleId add(const ConvexPolygon& polygon, Motion motion = Motion::free,
                 const Vec2& velocity = {0, 0}, double spin = 0, MaterialIndex material = 0) {
    require(material < sim().particles_.materials(), "material of the added body", material,
            "must be below the number of rocks");
    const Energy before = energy();
    const BodyIndex i = sim().particles_.add(polygon, motion, nullptr, material);
    sim().bonds_.add_body(sim().particles_);
    try {
      set_velocity(i, velocity, spin);
      update_contacts();
      sim().contacts_.check_overlaps(sim().particles_);
    } catch (const InvalidInput&) {
      take_away(i);
      throw;
    } catch (const SimulationError& error) {
      take_away(i);
      throw InvalidInput(error.what());
    }
    lower_time_step(sim().particles_.body(i));
    book(before);
    return sim().particles_.ancestry(i).id;
  }

  /// Removes the body with an id; those with higher indices move up by one. Other contacts keep
  /// their histories. The energy that goes with it is booked in `work().added`, negative. The time
  /// step stays. Throws InvalidInput if there is none, if it is the last one, or if the boundary
  /// needs it.
  void remove(ParticleId id) {
    const BodyIndex i = index_of(id);
    require(sim().particles_.size() > 1, "particle", id, "is the last one and must stay");
    if constexpr (requires { sim().boundary().remove(i); }) sim().boundary().remove(i);
    const Energy before = energy();
    take_away(i);
    book(before);
  }

  /// Where the body with an id is now, until the next break or removal. Throws InvalidInput if it
  /// has broken or was removed.
  [[nodiscard]] BodyIndex index_of(ParticleId id) const {
    const auto found = sim().particles().find(id);
    if (!found)
      throw InvalidInput(particle_text(id) +
                         ": must be in the simulation; it has broken or was removed");
    return *found;
  }

 private:
  friend Sim;
  BodyChanges() = default;
  [[nodiscard]] Sim& sim() { return static_cast<Sim&>(*this); }
  [[nodiscard]] const Sim& sim() const { return static_cast<const Sim&>(*this); }

  struct Energy {
    double held = 0;  // kinetic and stored [J]
    double lost = 0;  // to friction and dashpots, which a force that is found anew may add to [J]
  };
  [[nodiscard]] Energy energy() const {
    const auto& contacts = sim().contacts();
    return {kinetic_energy(sim().particles()) + stored_energy_of(sim()),
            contacts.friction_loss() + contacts.viscous_loss() + bond_loss(sim())};
  }
  void book(const Energy& before) {
    const Energy now = energy();
    sim().other_work_.added += now.held + now.lost - before.held - before.lost;
  }

  void take_away(BodyIndex i) {
    const std::size_t count = sim().particles_.size();
    sim().particles_.remove(i);
    sim().contacts_.remove(i);
    sim().bonds_.remove(i, sim().particles_, sim().contacts_);
    sim().breakage_.remove(i, count);
    sim().loads_.remove(i);
    if (auto& work = sim().work_; i < work.size()) {
      sim().other_work_ += work[i];
      work.erase(work.begin() + static_cast<std::ptrdiff_t>(i));
    }
    update_contacts();
  }
  void update_contacts() {
    sim().contacts_.update(sim().particles_, 0, sim().model_.execution_policy);
  }

  void lower_time_step(const Body& body) {
    if (!body.is_free() || body.mass >= sim().smallest_mass_) return;
    const double before = sim().time_step_;
    sim().choose_time_step();
    sim().time_step_ = std::min(before, sim().time_step_);
  }
};

}  // namespace riprap
