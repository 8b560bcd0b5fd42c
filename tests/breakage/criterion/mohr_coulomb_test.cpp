// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/criterion/mohr_coulomb.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/conformance/criterion.hpp>
#include <riprap/core/units.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::near_relative;

TEST_CASE("c = 10, phi = 30 degrees: the Mohr-Coulomb line has slope 3 and apex 17.32") {
  const MohrCoulomb soil{.cohesion = 10_MPa, .angle = 30_deg, .tension = 5_MPa};
  // 2 c sqrt(3) + 3 sigma_3 and c / tan 30; half a unit of the last printed digit in Pa.
  CHECK(soil.major_stress_at_failure(0) == near(34.641016e6, 0.6));
  CHECK(soil.major_stress_at_failure(10_MPa) == near(64.641016e6, 0.6));
  CHECK(soil.major_stress_at_failure(50_MPa) == near(184.641016e6, 0.6));
  CHECK(soil.apex() == near(17.320508e6, 0.6));
  CHECK(soil.tensile_strength() == 5_MPa);
}

TEST_CASE("the Mohr-Coulomb line meets the isotropic line at its apex") {
  const MohrCoulomb soil{.cohesion = 7_MPa, .angle = 41_deg, .tension = 1_MPa};
  CHECK(soil.major_stress_at_failure(-soil.apex()) == near_relative(-soil.apex(), 1e-13));
}

TEST_CASE("the Mohr circle at failure touches the line tau = c + sigma tan phi") {
  const MohrCoulomb soil{.cohesion = 3_MPa, .angle = 35_deg, .tension = 1_MPa};
  for (const double minor : {-1_MPa, 0_MPa, 12_MPa, 200_MPa}) {
    const double major = soil.major_stress_at_failure(minor);
    const double radius = 0.5 * (major - minor);
    const double distance =
        soil.cohesion * std::cos(soil.angle) + 0.5 * (major + minor) * std::sin(soil.angle);
    CHECK(radius == near_relative(distance, 1e-13));
  }
}

TEST_CASE("the friction angle of Mohr-Coulomb is the same at every stress") {
  const MohrCoulomb soil{.cohesion = 10_MPa, .angle = 30_deg, .tension = 5_MPa};
  CHECK(soil.friction_angle(-5_MPa) == 30_deg);
  CHECK(friction_angle(soil, 300_MPa) == 30_deg);
}

TEST_CASE("the default Mohr-Coulomb rock has the strengths and the angle of Table 1's rock") {
  const MohrCoulomb line;
  const HoekBrown curve;
  CHECK_NOTHROW(line.validate());
  // The defaults have eight digits: half a unit of the last one of the angle is 5e-8 rad, and the
  // strength changes by the factor 1 + 5e-8 / cos phi = 1 + 1.2e-7; that of the cohesion
  // adds 1.5e-8.
  CHECK(line.major_stress_at_failure(0) == near_relative(curve.major_stress_at_failure(0), 1.4e-7));
  CHECK(line.tensile_strength() == near_relative(curve.tensile_strength(), 1e-15));
  CHECK(line.friction_angle(0) == near(curve.friction_angle(0), 5.1e-8));
}

TEST_CASE("Mohr-Coulomb lines rise at least as fast as sigma_3") {
  CHECK(to_text(criterion_violations(MohrCoulomb{}, 300_MPa)) == "");
  const MohrCoulomb soft{.cohesion = 1_MPa, .angle = 5_deg, .tension = 2_MPa};
  // 2 c tan(45 deg + phi / 2)
  CHECK(to_text(criterion_violations(soft, 2_MPa * std::tan(47.5_deg))) == "");
}

TEST_CASE("Mohr-Coulomb parameters that break a rule are named") {
  const auto message = [](const MohrCoulomb& soil) {
    return test::message_of([&] { soil.validate(); });
  };
  CHECK(message({.cohesion = 0}) == "MohrCoulomb.cohesion = 0: must be a finite number above 0");
  CHECK(message({.angle = 2}) == "MohrCoulomb.angle = 2: must lie in (0, 1.5) rad");
  CHECK(message({.angle = 0}) == "MohrCoulomb.angle = 0: must lie in (0, 1.5) rad");
  CHECK(message({.tension = -1}) == "MohrCoulomb.tension = -1: must be a finite number above 0");
  const std::string past_apex = message({.cohesion = 10_MPa, .angle = 30_deg, .tension = 18_MPa});
  CHECK(past_apex.starts_with("MohrCoulomb.tension = 1.8e+07: must not pass the apex"));
  CHECK(test::contains(past_apex, "17320508.07"));
}
