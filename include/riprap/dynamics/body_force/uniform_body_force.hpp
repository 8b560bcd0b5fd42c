// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// The same acceleration for all free bodies, such as gravity: the default, with none.

#include <riprap/core/errors.hpp>
#include <riprap/dynamics/body_force/concepts.hpp>

namespace riprap {

struct UniformBodyForce {
  Vec2 acceleration{0, 0};  ///< [m/s^2]; gravity against axis 2 is {0, -9.81}

  [[nodiscard]] Vec2 operator()(const Body&) const { return acceleration; }

  static void for_each_field(auto& self, auto&& visit) { visit("acceleration", self.acceleration); }

  void validate() const {
    require_finite("body force along axis 1", acceleration.x());
    require_finite("body force along axis 2", acceleration.y());
  }
};

static_assert(BodyForce<UniformBodyForce>);

}  // namespace riprap
