#pragma once
/// @file
/// The role of the integrator: from force to motion over one time step.

#include <concepts>

#include <riprap/particle/body.hpp>

namespace riprap {

/// An `Integrator` advances one free body. A step calls `advance` with the wrench at the present
/// pose, then forces are evaluated anew, then `finish` is called with the new wrench (left out
/// where `needs_finish` is false, so that a one-kick scheme pays nothing).
///
/// - `I::order`: global order of accuracy in the time step; tests measure it.
/// - `I::needs_finish`: whether `finish` has work to do.
/// - `integrator.advance(body, wrench, time_step)`, `integrator.finish(body, wrench, time_step)`:
///   must use `mass_scaling * mass` and `mass_scaling * inertia`. Kinetic energy must change by
///   exactly the work of the wrench over the mean of the velocities before and after, in each call:
///   during half the time step where `needs_finish` is true, else during all of it.
template <class I>
concept Integrator =
    requires(const I& integrator, Body& body, const Wrench& wrench, double time_step) {
      { I::order } -> std::convertible_to<int>;
      { I::needs_finish } -> std::convertible_to<bool>;
      integrator.advance(body, wrench, time_step);
      integrator.finish(body, wrench, time_step);
    };

/// Moves a body at its present velocity: the drift of every scheme, and all that a driven body
/// does.
inline void drift(Body& body, double time_step) {
  body.position += time_step * body.velocity;
  if (body.angular_velocity != 0)
    body.rotation = body.rotation.turned(time_step * body.angular_velocity);
}

/// Changes a body's velocity by the impulse of a constant wrench.
inline void kick(Body& body, const Wrench& wrench, double time_step) {
  const double scaled = time_step / body.mass_scaling;
  body.velocity += (scaled / body.mass) * wrench.force;
  body.angular_velocity += (scaled / body.inertia) * wrench.moment;
}

}  // namespace riprap
