// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/criterion/murrell.hpp>

#include <doctest/doctest.h>

#include <riprap/conformance/criterion.hpp>
#include <riprap/core/units.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::near_relative;

namespace {

struct Row {
  double x;
  double expected;
};

}  // namespace

TEST_CASE("the Murrell curve is the paraboloid at two equal minor stresses") {
  // T = 12 MPa, from the equation in three dimensions by bisection in 30 digits; half a unit of the
  // last printed digit.
  const Murrell rock;
  for (const Row& row :
       {Row{-11, 81.7846097}, Row{-6, 116.911688}, Row{0, 144}, Row{5, 162.697141},
        Row{10, 179.488461}, Row{25, 223.427845}, Row{50, 285.65818}, Row{100, 391.963633}}) {
    CAPTURE(row.x);
    const double minor = row.x * 1e6;
    const double major = rock.major_stress_at_failure(minor);
    CHECK(major == near_relative(row.expected * 1e6, 5e-9));
    const double deviation = 2 * (major - minor) * (major - minor);
    CHECK(deviation == near_relative(24 * 12_MPa * (major + 2 * minor), 1e-13));
  }
}

TEST_CASE("Murrell rock is twelve times as strong in compression as in tension") {
  const Murrell rock{.tension = 25_MPa};
  CHECK(rock.tensile_strength() == 25_MPa);
  CHECK(rock.major_stress_at_failure(0) == near_relative(300_MPa, 1e-15));
  // The paraboloid touches the plane of tensile failure at (5 T, -T, -T).
  CHECK(rock.major_stress_at_failure(-25_MPa) == near_relative(125_MPa, 1e-15));
}

TEST_CASE("the friction angle of Murrell rock is that of the slope of its curve") {
  const Murrell rock;
  // asin((k - 1) / (k + 1)) by a central difference in 30 digits; half a unit of the last digit.
  for (const Row& row : {Row{-6, 42.814171}, Row{5, 33.888015}, Row{50, 23.425633}})
    CHECK(rock.friction_angle(row.x * 1e6) == near(row.expected * 1_deg, 1e-8));
  CHECK(rock.friction_angle(-12_MPa) == near(90_deg, 1e-15));
}

TEST_CASE("Murrell curves obey the axioms in any units") {
  CHECK(to_text(criterion_violations(Murrell{}, 144_MPa)) == "");
  CHECK(to_text(criterion_unit_violations(Murrell{}, Murrell{.tension = 12})) == "");
}

TEST_CASE("the tensile strength of Murrell rock must be a positive number") {
  CHECK_NOTHROW(Murrell{}.validate());
  CHECK(test::message_of([] { Murrell{.tension = -1}.validate(); }) ==
        "Murrell.tension = -1: must be a finite number above 0");
}
