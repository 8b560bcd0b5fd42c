// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// A time step that is given, with true masses everywhere. The file to copy for a rule of your own.

#include <riprap/core/errors.hpp>
#include <riprap/dynamics/time_step/concepts.hpp>

namespace riprap {

/// The same step for every sample, whatever its masses and stiffness; stability is the user's
/// responsibility.
struct FixedTimeStep {
  double seconds = 5e-7;  ///< [s]; MassFloor gives 8.5e-7 for squares of 5 mm, 16 mm thick

  [[nodiscard]] double time_step(double /*mass*/, double /*stiffness*/) const { return seconds; }
  [[nodiscard]] double mass_scaling(double /*mass*/, double /*smallest*/) const { return 1; }

  static void for_each_field(auto& self, auto&& visit) { visit("seconds", self.seconds); }

  void validate() const { require_positive("FixedTimeStep.seconds", seconds); }
};

static_assert(TimeStep<FixedTimeStep>);

}  // namespace riprap
