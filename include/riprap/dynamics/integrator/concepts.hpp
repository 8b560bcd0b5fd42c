// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the integrator: from force to motion over one time step.

#include <type_traits>

#include <riprap/core/policy.hpp>
#include <riprap/particle/body.hpp>

namespace riprap {

namespace requirements {

/// `I::order`: global order of accuracy in the time step; a constant, which tests measure.
template <class I>
concept IntegratorOrder = requires {
  *&I::order;  // of the class
  typename std::integral_constant<int, int{I::order}>;
};

/// `I::has_second_kick`: whether `second_kick` has work to do; a constant, so that a one-kick
/// scheme pays nothing for the second.
template <class I>
concept IntegratorHasSecondKick = requires {
  *&I::has_second_kick;
  typename std::bool_constant<bool{I::has_second_kick}>;
};

/// `integrator.advance(body, wrench, time_step)`: from the wrench [N, N m] at the present pose to
/// the next pose. Const, for one integrator serves all bodies.
template <class I>
concept IntegratorAdvance =
    requires(const I& integrator, Body& body, const Wrench& wrench, const double time_step) {
      integrator.advance(body, wrench, time_step);
    };

/// `integrator.second_kick(body, wrench, time_step)`: the second kick, with the wrench at the new
/// pose.
template <class I>
concept IntegratorSecondKick =
    requires(const I& integrator, Body& body, const Wrench& wrench, const double time_step) {
      integrator.second_kick(body, wrench, time_step);
    };

/// Optional: `integrator.first_kick_fraction()` [-]. A non-const function would be ignored
/// silently, and work would be accounted wrongly.
template <class I>
concept IntegratorFirstKickFraction = !requires(I& integrator) {
  integrator.first_kick_fraction();
} || requires(const I& integrator) {
  { integrator.first_kick_fraction() } -> std::convertible_to<double>;
};

}  // namespace requirements

/// An `Integrator` advances one free body. A step calls `advance` with the wrench at the present
/// pose, then forces are evaluated anew, then `second_kick` is called with the new wrench (left out
/// where `has_second_kick` is false). Both must use `mass_scaling * mass` and `mass_scaling *
/// inertia`. Each does its work over its own share of the step: in either call kinetic energy must
/// change by exactly the work of that call's wrench, force and moment, over the mean of the
/// velocities before and after, times the share. The energy ledger books it so.
///
/// Optional: `integrator.first_kick_fraction()` [-], the share of `advance`, 0 to 1; `second_kick`
/// has the rest. Without it: one half where `has_second_kick`, else all.
template <class I>
concept Integrator =
    Policy<I> && requirements::IntegratorOrder<I> && requirements::IntegratorHasSecondKick<I> &&
    requirements::IntegratorAdvance<I> && requirements::IntegratorSecondKick<I> &&
    requirements::IntegratorFirstKickFraction<I>;

template <class I>
consteval bool check_integrator() {
  check_policy<I>();
  static_assert(requirements::IntegratorOrder<I>,
                "riprap: an Integrator must have static constexpr int order");
  static_assert(requirements::IntegratorHasSecondKick<I>,
                "riprap: an Integrator must have static constexpr bool has_second_kick");
  static_assert(
      requirements::IntegratorAdvance<I>,
      "riprap: an Integrator must have void advance(Body&, const Wrench&, double time_step) const");
  static_assert(requirements::IntegratorSecondKick<I>,
                "riprap: an Integrator must have void second_kick(Body&, const Wrench&, double "
                "time_step) const");
  static_assert(
      requirements::IntegratorFirstKickFraction<I>,
      "riprap: an Integrator's first_kick_fraction must be double first_kick_fraction() const");
  return Integrator<I>;
}

/// Share of the step's impulse that `advance` gives [-]; `second_kick` gives the rest.
template <Integrator I>
[[nodiscard]] double first_kick_fraction(const I& integrator) {
  if constexpr (requires { integrator.first_kick_fraction(); })
    return integrator.first_kick_fraction();
  else
    return I::has_second_kick ? 0.5 : 1;
}

/// Moves a body at its present velocity: the drift of every scheme, and all that a driven body
/// does.
inline void drift(Body& body, double time_step) {
  body.position.x() += time_step * body.velocity.x();
  body.position.y() += time_step * body.velocity.y();
  if (body.angular_velocity != 0)
    body.rotation = body.rotation.turned(time_step * body.angular_velocity);
}

/// Changes a body's velocity by the impulse of a constant wrench.
inline void kick(Body& body, const Wrench& wrench, double time_step) {
  const double per_force = time_step / (body.mass_scaling * body.mass);
  body.velocity.x() += per_force * wrench.force.x();
  body.velocity.y() += per_force * wrench.force.y();
  body.angular_velocity += (time_step / (body.mass_scaling * body.inertia)) * wrench.moment;
}

}  // namespace riprap
