// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Rankine's criterion: rock fails in tension only.

#include <limits>

#include <riprap/breakage/criterion/concepts.hpp>
#include <riprap/core/errors.hpp>

namespace riprap {

/// Fails where sigma_3 <= -tension, whatever the other principal stress (Rankine 1857).
struct Rankine {
  double tension = 12e6;  ///< tensile strength [Pa]

  [[nodiscard]] double major_stress_at_failure(double /*minor*/) const {
    return std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] double tensile_strength() const { return tension; }

  static void for_each_field(auto& self, auto&& visit) { visit("tension", self.tension); }

  void validate() const { require_positive("Rankine.tension", tension); }
};

static_assert(Criterion<Rankine>);

}  // namespace riprap
