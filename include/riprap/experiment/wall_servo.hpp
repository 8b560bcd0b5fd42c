// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Holds the force on one wall by moving the wall.

#include <string>

#include <riprap/core/errors.hpp>
#include <riprap/core/ids.hpp>
#include <riprap/core/vec2.hpp>
#include <riprap/experiment/pressure_servo.hpp>
#include <riprap/particle/particles.hpp>

namespace riprap {

/// Sets the velocity of a driven body so that it pushes with a given force. To be called before
/// every step, after which the velocity holds; it is along one direction, without spin. The body is
/// known by its id, so that others may come and go.
///
///     WallServo servo(lid, {0, -1}, 500, 2e7, 1e-4, 0.1);
///     for (int n = 0; n < 10000; ++n) {
///       servo(sim);
///       sim.step();
///     }
class WallServo {
 public:
  /// @param wall      id of the body; in a new simulation that is its place in the assembly
  /// @param direction in which it pushes; its length does not count
  /// @param force     to hold [N], positive: the component of the contact force on the body against
  ///                  `direction`
  /// @param stiffness of what it pushes against [N/m]: critically damped for it, unstable where
  ///                  that is much stiffer
  /// @param response  time in which the force follows [s]: several time steps
  /// @param largest_speed [m/s]
  /// Throws InvalidInput unless all are finite and the last three above 0.
  WallServo(ParticleId wall, const Vec2& direction, double force, double stiffness, double response,
            double largest_speed)
      : wall_(wall), direction_(unit(direction)),
        control_(positive("WallServo: stiffness", stiffness),
                 positive("WallServo: response", response),
                 positive("WallServo: largest speed", largest_speed)) {
    set_force(force);
  }

  void set_force(double force) {
    require_finite("WallServo: force", force);
    force_ = force;
  }

  /// The force with which the body pushes now [N]. Throws InvalidInput if it has gone.
  template <class Sim>
  [[nodiscard]] double pushes_with(const Sim& sim) const {
    return pushes_with(sim, sim.index_of(wall_));
  }

  /// Throws InvalidInput if the body has gone.
  template <class Sim>
  void operator()(Sim& sim) {
    const BodyIndex i = sim.index_of(wall_);
    const double speed = control_.rate(force_ - pushes_with(sim, i), sim.time_step());
    sim.set_velocity(i, speed * direction_);
  }

  static constexpr bool names_all_members = true;
  static void for_each_field(auto& self, auto&& visit) {
    visit("wall", self.wall_);
    visit("direction", self.direction_);
    visit("force", self.force_);
    visit("control", self.control_);
  }

 private:
  [[nodiscard]] static Vec2 unit(const Vec2& direction) {
    require(is_finite(direction) && direction.norm() > 0, "WallServo: length of direction",
            direction.norm(), "must be a finite number above 0");
    return direction / direction.norm();
  }
  [[nodiscard]] static double positive(const char* name, double value) {
    require_positive(name, value);
    return value;
  }

  [[nodiscard]] double pushes_with(const auto& sim, BodyIndex i) const {
    return -direction_.dot(sim.force_on(i).force);
  }

  ParticleId wall_;
  Vec2 direction_;
  double force_ = 0;
  PressureServo control_;
};

}  // namespace riprap
