// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Free bodies stay where they are. The file to copy for an integrator of your own.

#include <riprap/dynamics/integrator/concepts.hpp>

namespace riprap {

/// Stops every free body where it is and keeps it there: driven bodies press on a rigid
/// arrangement. Of order 0, for no time step is short enough; the kinetic energy of a body that is
/// stopped is lost.
struct Frozen {
  static constexpr int order = 0;
  static constexpr bool has_second_kick = false;

  void advance(Body& body, const Wrench&, double) const {
    body.velocity = Vec2{0, 0};
    body.angular_velocity = 0;
  }
  void second_kick(Body&, const Wrench&, double) const {}
};

static_assert(Integrator<Frozen>);

}  // namespace riprap
