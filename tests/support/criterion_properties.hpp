#pragma once
/// @file
/// What every failure criterion must satisfy, whatever its formula.

#include <doctest/doctest.h>

#include <numbers>

#include <riprap/breakage/criterion/concepts.hpp>

namespace riprap::test {

/// Between the tensile strength and ten times it on the side of compression: the curve rises at
/// least as fast as sigma_3, lies above the isotropic line, and has a friction angle.
template <FailureCriterion C>
void check_criterion_properties(const C& criterion) {
  const double tensile = criterion.tensile_strength();
  REQUIRE(tensile > 0);
  constexpr int samples = 440;
  double minor = -tensile;
  double limit = criterion.major_stress_at_failure(minor);
  for (int i = 1; i <= samples; ++i) {
    const double next_minor = -tensile + 11 * tensile * i / samples;
    const double next_limit = criterion.major_stress_at_failure(next_minor);
    CAPTURE(next_minor);
    // Round-off of two stresses of the size of `limit`.
    const double round_off = 1e-15 * (next_limit + tensile);
    CHECK(next_limit - limit >= next_minor - minor - round_off);
    CHECK(next_limit > next_minor);
    const double angle = friction_angle(criterion, next_minor);
    CHECK(angle > 0);
    CHECK(angle < 0.5 * std::numbers::pi);
    minor = next_minor;
    limit = next_limit;
  }
}

}  // namespace riprap::test
