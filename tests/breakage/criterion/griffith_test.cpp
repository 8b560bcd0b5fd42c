// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/criterion/griffith.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/breakage/failure/element_failure.hpp>
#include <riprap/conformance/criterion.hpp>
#include <riprap/core/units.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::near_relative;

TEST_CASE("the Griffith curve passes through the solutions of his equation") {
  // (sigma_1 - sigma_3)^2 = 8 T (sigma_1 + sigma_3) with T = 12 MPa, by bisection in 30 digits.
  const Griffith rock;
  struct Row {
    double minor;
    double major;
  };
  for (const Row& row :
       {Row{-11, 50.8564065}, Row{-6, 75.9411255}, Row{0, 96}, Row{5, 110.131427},
        Row{10, 122.992307}, Row{25, 157.28523}, Row{50, 207.105454}, Row{100, 294.642422}}) {
    CAPTURE(row.minor);
    // Half a unit of the last of nine printed digits.
    CHECK(rock.major_stress_at_failure(row.minor * 1e6) == near_relative(row.major * 1e6, 5e-9));
  }
}

TEST_CASE("Griffith rock is eight times as strong in compression as in tension") {
  const Griffith rock{.tension = 7_MPa};
  CHECK(rock.tensile_strength() == 7_MPa);
  CHECK(rock.major_stress_at_failure(0) == near_relative(56_MPa, 1e-15));
  // Where the two parts of the criterion meet: sigma_1 + 3 sigma_3 = 0.
  CHECK(rock.major_stress_at_failure(-7_MPa) == near_relative(21_MPa, 1e-15));
  CHECK(evaluate(rock, Stress2{20_MPa, -7_MPa, 0}).mode == FailureMode::tension);
  CHECK(evaluate(rock, Stress2{24.4_MPa, -6.9_MPa, 0}).mode == FailureMode::intact);
  CHECK(evaluate(rock, Stress2{24.5_MPa, -6.9_MPa, 0}).mode == FailureMode::shear);
}

TEST_CASE("the shear planes of Griffith rock are the cracks that grow") {
  const Griffith rock;
  for (const double minor : {-11.9_MPa, -6_MPa, 0_MPa, 5_MPa, 100_MPa}) {
    const double major = rock.major_stress_at_failure(minor);
    // Inclined to the major stress by psi, cos 2 psi = (sigma_1 - sigma_3) / 2 (sigma_1 + sigma_3).
    const double psi = 0.5 * std::acos((major - minor) / (2 * (major + minor)));
    const FailurePlanes planes = failure_planes(rock, Stress2{major, minor, 0}, FailureMode::shear);
    REQUIRE(planes.count == 2);
    // An arccosine near 1 has half the digits.
    CHECK(planes.angle_to(Vec2{std::cos(psi), std::sin(psi)}) == near(0, 2e-8));
    CHECK(planes.angle_to(Vec2{std::cos(psi), -std::sin(psi)}) == near(0, 2e-8));
  }
  CHECK(rock.friction_angle(0) == near(30_deg, 1e-15));
  CHECK(rock.friction_angle(-12_MPa) == near(90_deg, 1e-15));
}

TEST_CASE("Griffith curves obey the axioms in any units") {
  CHECK(to_text(criterion_violations(Griffith{.tension = 3_MPa}, 24_MPa)) == "");
  CHECK(to_text(criterion_unit_violations(Griffith{}, Griffith{.tension = 12})) == "");
}

TEST_CASE("the tensile strength of Griffith rock must be a positive number") {
  CHECK_NOTHROW(Griffith{}.validate());
  CHECK(test::message_of([] { Griffith{.tension = 0}.validate(); }) ==
        "Griffith.tension = 0: must be a finite number above 0");
}
