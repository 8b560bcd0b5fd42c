// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Symplectic Euler: the default integrator of the discrete element method.

#include <riprap/dynamics/integrator/concepts.hpp>

namespace riprap {

/// Kick, then drift. First order in the velocities as they stand; with velocities read as those
/// half a step earlier it is the leapfrog scheme, of second order.
struct SymplecticEuler {
  static constexpr int order = 1;
  static constexpr bool has_second_kick = false;

  void advance(Body& body, const Wrench& wrench, double time_step) const {
    kick(body, wrench, time_step);
    drift(body, time_step);
  }
  void second_kick(Body&, const Wrench&, double) const {}
};

static_assert(Integrator<SymplecticEuler>);

}  // namespace riprap
