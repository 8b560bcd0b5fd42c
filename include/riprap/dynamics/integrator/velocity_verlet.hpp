// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Velocity Verlet: positions and velocities at the same instants, second order in both.

#include <riprap/dynamics/integrator/concepts.hpp>

namespace riprap {

/// Half a kick, a drift, half a kick with the new forces (Swope et al. 1982).
struct VelocityVerlet {
  static constexpr int order = 2;
  static constexpr bool has_second_kick = true;

  void advance(Body& body, const Wrench& wrench, double time_step) const {
    kick(body, wrench, 0.5 * time_step);
    drift(body, time_step);
  }
  void second_kick(Body& body, const Wrench& wrench, double time_step) const {
    kick(body, wrench, 0.5 * time_step);
  }
};

static_assert(Integrator<VelocityVerlet>);

}  // namespace riprap
