// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The role of the integrator: from force to motion over one time step.

#include <type_traits>

#include <riprap/core/policy.hpp>
#include <riprap/particle/body.hpp>

namespace riprap {

namespace clauses {

/// `I::order`: global order of accuracy in the time step; a constant, which tests measure.
template <class I>
concept IntegratorOrder = requires {
  *&I::order;  // of the class
  typename std::integral_constant<int, int{I::order}>;
};

/// `I::needs_finish`: whether `finish` has work to do; a constant, so that a one-kick scheme pays
/// nothing for the second.
template <class I>
concept IntegratorNeedsFinish = requires {
  *&I::needs_finish;
  typename std::bool_constant<bool{I::needs_finish}>;
};

/// `integrator.advance(body, wrench, time_step)`: from the wrench [N, N m] at the present pose to
/// the next pose. Const, for one integrator serves all bodies.
template <class I>
concept IntegratorAdvance =
    requires(const I& integrator, Body& body, const Wrench& wrench, const double time_step) {
      integrator.advance(body, wrench, time_step);
    };

/// `integrator.finish(body, wrench, time_step)`: the second kick, with the wrench at the new pose.
template <class I>
concept IntegratorFinish =
    requires(const I& integrator, Body& body, const Wrench& wrench, const double time_step) {
      integrator.finish(body, wrench, time_step);
    };

/// Optional: `integrator.first_kick()` [-]. Not const, it would be passed over in silence, and work
/// would be booked wrongly.
template <class I>
concept IntegratorFirstKick =
    !requires(I& integrator) { integrator.first_kick(); } || requires(const I& integrator) {
      { integrator.first_kick() } -> std::convertible_to<double>;
    };

}  // namespace clauses

/// An `Integrator` advances one free body. A step calls `advance` with the wrench at the present
/// pose, then forces are evaluated anew, then `finish` is called with the new wrench (left out
/// where `needs_finish` is false). Both must use `mass_scaling * mass` and `mass_scaling *
/// inertia`. Each does its work over its own share of the step: in either call kinetic energy must
/// change by exactly the work of that call's wrench, force and moment, over the mean of the
/// velocities before and after, times the share. The energy ledger books it so.
///
/// Optional: `integrator.first_kick()` [-], the share of `advance`, 0 to 1; `finish` has the rest.
/// Without it: one half where `needs_finish`, else all.
template <class I>
concept Integrator = Policy<I> && clauses::IntegratorOrder<I> &&
                     clauses::IntegratorNeedsFinish<I> && clauses::IntegratorAdvance<I> &&
                     clauses::IntegratorFinish<I> && clauses::IntegratorFirstKick<I>;

template <class I>
consteval bool check_integrator() {
  check_policy<I>();
  static_assert(clauses::IntegratorOrder<I>,
                "riprap: an Integrator must have static constexpr int order");
  static_assert(clauses::IntegratorNeedsFinish<I>,
                "riprap: an Integrator must have static constexpr bool needs_finish");
  static_assert(
      clauses::IntegratorAdvance<I>,
      "riprap: an Integrator must have void advance(Body&, const Wrench&, double time_step) const");
  static_assert(
      clauses::IntegratorFinish<I>,
      "riprap: an Integrator must have void finish(Body&, const Wrench&, double time_step) const");
  static_assert(clauses::IntegratorFirstKick<I>,
                "riprap: an Integrator's first_kick must be double first_kick() const");
  return Integrator<I>;
}

/// Share of the step's impulse that `advance` gives [-]; `finish` gives the rest.
template <Integrator I>
[[nodiscard]] double first_kick(const I& integrator) {
  if constexpr (requires { integrator.first_kick(); })
    return integrator.first_kick();
  else
    return I::needs_finish ? 0.5 : 1;
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
