// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Cundall's local non-viscous damping: the default.

#include <cmath>

#include <riprap/core/errors.hpp>
#include <riprap/dynamics/damping/concepts.hpp>

namespace riprap {

/// A force against the motion, a fixed share of the applied one, component by component
/// (Cundall 1987). It vanishes in equilibrium and is the same for every natural frequency.
struct LocalDamping {
  double coefficient = 0.7;  ///< [-], in [0, 1); the usual choice for quasi-static problems

  [[nodiscard]] Wrench operator()(const Body& body, const Wrench& applied) const {
    return {{against(applied.force.x(), body.velocity.x()),
             against(applied.force.y(), body.velocity.y())},
            against(applied.moment, body.angular_velocity)};
  }

  static void for_each_field(auto& self, auto&& visit) { visit("coefficient", self.coefficient); }

  void validate() const {
    require(coefficient >= 0 && coefficient < 1, "LocalDamping.coefficient", coefficient,
            "must lie in [0, 1)");
  }

 private:
  [[nodiscard]] double against(double force, double velocity) const {
    if (velocity == 0) return 0;
    return -std::copysign(coefficient * std::abs(force), velocity);
  }
};

static_assert(Damping<LocalDamping>);

}  // namespace riprap
