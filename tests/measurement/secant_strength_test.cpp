// SPDX-License-Identifier: BSL-1.0
#include <riprap/measurement/secant_strength.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/core/units.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::message_of;
using test::near_relative;

namespace {

// A handful of operations on numbers of order one.
constexpr double round_off = 2e-15;

}  // namespace

TEST_CASE("sin phi of one half at 2 MPa") {
  // sigma_1 = 6 MPa: centre 4, radius 2; the tangent touches at 4 cos^2 30 = 3 and 3 tan 30.
  const SecantStrength s = secant_strength(0.5, 2.0_MPa);
  CHECK(s.friction_angle == near_relative(30.0_deg, round_off));
  CHECK(s.normal_stress == near_relative(3e6, round_off));
  CHECK(s.shear_stress == near_relative(std::sqrt(3.0) * 1e6, round_off));
}

TEST_CASE("the point lies on the Mohr circle and no other point of that is steeper") {
  for (const double sin_phi : {0.01, 0.3, 0.6, 0.8, 0.99}) {
    CAPTURE(sin_phi);
    const double minor = 0.5e6;
    const double major = minor * (1 + sin_phi) / (1 - sin_phi);
    const double centre = 0.5 * (major + minor);
    const double radius = 0.5 * (major - minor);
    const SecantStrength s = secant_strength(sin_phi, minor);
    // Centre and radius nearly cancel the minor stress at the largest ratio, 199.
    CHECK(std::hypot(s.normal_stress - centre, s.shear_stress) ==
          near_relative(radius, 200 * round_off));
    CHECK(s.shear_stress / s.normal_stress ==
          near_relative(std::tan(s.friction_angle), 200 * round_off));
    for (int i = 1; i < 180; ++i) {
      const double turn = i * 1.0_deg;
      const double slope = radius * std::sin(turn) / (centre + radius * std::cos(turn));
      CHECK(slope <= std::tan(s.friction_angle) * (1 + 200 * round_off));
    }
  }
}

TEST_CASE("an isotropic state has no strength and the pressure itself as its normal stress") {
  const SecantStrength s = secant_strength(0, 3e6);
  CHECK(s.friction_angle == 0);
  CHECK(s.normal_stress == 3e6);
  CHECK(s.shear_stress == 0);
}

TEST_CASE("the angle does not depend on the unit of stress, and the stresses follow it") {
  const SecantStrength in_pascal = secant_strength(0.62, 8e6);
  const SecantStrength in_megapascal = secant_strength(0.62, 8);
  CHECK(in_pascal.friction_angle == in_megapascal.friction_angle);
  CHECK(in_pascal.normal_stress == near_relative(1e6 * in_megapascal.normal_stress, round_off));
  CHECK(in_pascal.shear_stress == near_relative(1e6 * in_megapascal.shear_stress, round_off));
}

TEST_CASE("states that are none of a test are refused") {
  CHECK(message_of([] { (void)secant_strength(1, 1e6); }) == "sin phi = 1: must lie in [0, 1)");
  CHECK(message_of([] { (void)secant_strength(-0.1, 1e6); }) ==
        "sin phi = -0.1: must lie in [0, 1)");
  CHECK(message_of([] { (void)secant_strength(std::nan(""), 1e6); }) ==
        "sin phi = nan: must lie in [0, 1)");
  CHECK(message_of([] { (void)secant_strength(0.5, 0); }) ==
        "minor stress = 0: must be a finite number above 0");
}
