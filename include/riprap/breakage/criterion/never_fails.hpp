// SPDX-License-Identifier: BSL-1.0
#pragma once
/// @file
/// Nothing ever fails: riprap as a plain polygon DEM, without any stress analysis.

#include <limits>

#include <riprap/breakage/criterion/concepts.hpp>

namespace riprap {

/// Infinite strength.
struct NeverFails {
  static constexpr bool never_fails = true;

  [[nodiscard]] double major_stress_at_failure(double /*minor*/) const {
    return std::numeric_limits<double>::infinity();
  }
  [[nodiscard]] double tensile_strength() const { return std::numeric_limits<double>::infinity(); }
};

static_assert(Criterion<NeverFails>);

}  // namespace riprap
