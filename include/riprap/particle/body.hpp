// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A rigid body: pose, motion, load and mass.

#include <riprap/core/vec2.hpp>

namespace riprap {

/// Force [N] and moment about the body's centroid [N m].
struct Wrench {
  Vec2 force{0, 0};
  double moment = 0;

  // Component by component: on pairs of numbers compilers spend more on packing than they save.
  void add(const Vec2& f, double m) {
    force.x() += f.x();
    force.y() += f.y();
    moment += m;
  }
  void subtract(const Vec2& f, double m) {
    force.x() -= f.x();
    force.y() -= f.y();
    moment -= m;
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("force", self.force);
    visit("moment", self.moment);
  }
};

/// What decides a body's velocity.
enum class Motion : unsigned char {
  free,          ///< Newton's law
  prescribed,    ///< the velocity it was given, whatever pushes it (zero: a fixed body)
  strain_field,  ///< the boundary's strain-rate field; it does not rotate and does not break
  platen,        ///< a rigid, smooth wall that the boundary moves along its normal
  wall,  ///< a rigid wall with the friction of the contact law, moved like a prescribed body
};
/// A wall or a platen: no part of the sample.
[[nodiscard]] constexpr bool is_wall(Motion motion) {
  return motion == Motion::wall || motion == Motion::platen;
}

/// A rigid body; its shape is stored beside it in Particles.
struct Body {
  Vec2 position{0, 0};          ///< of the centroid [m]
  Rotation rotation;            ///< from the body's own frame to the laboratory's
  Vec2 velocity{0, 0};          ///< [m/s]
  double angular_velocity = 0;  ///< [rad/s]
  Wrench contact;               ///< sum over all contacts, as of the last force evaluation
  double mass = 0;              ///< true mass [kg]
  double inertia = 0;           ///< true polar moment of inertia [kg m^2]
  double mass_scaling = 1;      ///< >= 1: factor on both in the equations of motion only
  Motion motion = Motion::free;

  [[nodiscard]] bool is_free() const { return motion == Motion::free; }
  [[nodiscard]] bool is_wall() const { return riprap::is_wall(motion); }

  /// Kinetic energy [J] with the mass that enters the equations of motion.
  [[nodiscard]] double kinetic_energy() const {
    return 0.5 * mass_scaling *
           (mass * velocity.dot(velocity) + inertia * angular_velocity * angular_velocity);
  }
  /// Velocity [m/s] of the material point at `arm` from the centroid.
  [[nodiscard]] Vec2 velocity_at(const Vec2& arm) const {
    using namespace internal;
    return vec2_of(pair_of(velocity) +
                   swapped(pair_of(arm)) * TwoDoubles{-angular_velocity, angular_velocity});
  }

  static void for_each_field(auto& self, auto&& visit) {
    visit("position", self.position);
    visit("rotation", self.rotation);
    visit("velocity", self.velocity);
    visit("angular_velocity", self.angular_velocity);
    visit("contact", self.contact);
    visit("mass", self.mass);
    visit("inertia", self.inertia);
    visit("mass_scaling", self.mass_scaling);
    visit("motion", self.motion);
  }
};

}  // namespace riprap
