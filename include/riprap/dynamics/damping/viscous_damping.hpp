// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Global viscous damping: a drag proportional to mass and velocity.

#include <riprap/core/errors.hpp>
#include <riprap/dynamics/damping/concepts.hpp>

namespace riprap {

/// Force -rate m v and moment -rate I omega, with the masses that enter the equations of motion.
/// Drags on steady flow too; prefer LocalDamping for quasi-static tests.
struct ViscousDamping {
  double rate = 100;  ///< [1/s]; velocities of a free body decay as exp(-rate t)

  [[nodiscard]] Wrench operator()(const Body& body, const Wrench& /*applied*/) const {
    const double scaled = rate * body.mass_scaling;
    return {-(scaled * body.mass) * body.velocity,
            -(scaled * body.inertia) * body.angular_velocity};
  }

  static void for_each_field(auto& self, auto&& visit) { visit("rate", self.rate); }

  void validate() const { require_non_negative("ViscousDamping.rate", rate); }
};

static_assert(Damping<ViscousDamping>);

}  // namespace riprap
