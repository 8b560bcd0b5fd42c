// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// True masses everywhere: the time step is chosen for the lightest piece that may come.

#include <cmath>

#include <riprap/core/errors.hpp>
#include <riprap/dynamics/time_step/concepts.hpp>

namespace riprap {

/// dt = fraction * sqrt(lightest * m / k) with m the smallest intact particle's mass; no body is
/// made heavier. Give `lightest` the smallest mass of a piece over m.
struct NoMassScaling {
  double fraction = 0.24;  ///< of sqrt(m / k) of the lightest piece [-]
  double lightest = 0.1;   ///< mass of the lightest piece over the smallest intact particle's [-]

  [[nodiscard]] double time_step(double mass, double stiffness) const {
    return fraction * std::sqrt(lightest * mass / stiffness);
  }
  [[nodiscard]] double mass_scaling(double /*mass*/, double /*smallest*/) const { return 1; }

  static void for_each_field(auto& self, auto&& visit) {
    visit("fraction", self.fraction);
    visit("lightest", self.lightest);
  }

  void validate() const {
    require_positive("NoMassScaling.fraction", fraction);
    require(lightest > 0 && lightest <= 1, "NoMassScaling.lightest", lightest,
            "must lie in (0, 1]");
  }
};

static_assert(TimeStep<NoMassScaling>);

}  // namespace riprap
