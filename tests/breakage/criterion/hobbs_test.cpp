// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/criterion/hobbs.hpp>

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include <riprap/breakage/criterion/hoek_brown.hpp>
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

TEST_CASE("the Hobbs curve passes through the computed points") {
  // sigma_3 + 300 + 4.4 300^0.3 sigma_3^0.7 in MPa, in 30 digits, and the line 300 + 25 sigma_3.
  const Hobbs rock;
  for (const Row& row :
       {Row{-12, 0}, Row{-11, 25}, Row{-6, 150}, Row{0, 300}, Row{5, 380.139458},
        Row{10, 432.064409}, Row{25, 556.817949}, Row{50, 726.589369}, Row{100, 1011.77123}}) {
    CAPTURE(row.x);
    // Half a unit of the last printed digit.
    CHECK(rock.major_stress_at_failure(row.x * 1e6) == near_relative(row.expected * 1e6, 5e-9));
  }
}

TEST_CASE("Hobbs rock has the strengths that it is given") {
  const Hobbs rock{.compressive_strength = 80_MPa, .tension = 5_MPa};
  CHECK(rock.tensile_strength() == 5_MPa);
  CHECK(rock.major_stress_at_failure(0) == 80_MPa);
}

TEST_CASE("the default Hobbs rock is within 19 MPa of the default Hoek-Brown rock") {
  double largest = 0;
  for (int i = 0; i <= 1500; ++i) {
    const double minor = i * 0.1_MPa;
    largest = std::max(largest, std::abs(Hobbs{}.major_stress_at_failure(minor) -
                                         HoekBrown{}.major_stress_at_failure(minor)));
  }
  CHECK(largest < 19_MPa);
  CHECK(largest > 17_MPa);
}

TEST_CASE("with exponent 1 the Hobbs curve is a straight line") {
  const Hobbs line{.compressive_strength = 100_MPa, .factor = 3, .exponent = 1, .tension = 10_MPa};
  for (const double minor : {0_MPa, 1_MPa, 40_MPa})
    CHECK(line.major_stress_at_failure(minor) == near_relative(100_MPa + 4 * minor, 1e-15));
  CHECK(line.friction_angle(40_MPa) == near(std::asin(3.0 / 5), 1e-15));
}

TEST_CASE("the friction angle of Hobbs rock is that of the slope of its curve") {
  const Hobbs rock;
  // asin((k - 1) / (k + 1)) by a central difference in 30 digits; half a unit of the last digit.
  for (const Row& row : {Row{-6, 67.380135}, Row{5, 57.166478}, Row{50, 46.46735}})
    CHECK(rock.friction_angle(row.x * 1e6) == near(row.expected * 1_deg, 1e-7));
  CHECK(rock.friction_angle(0) == rock.friction_angle(-12_MPa));
  // The slope is infinite there: the angle is short of 90 degrees by a power 0.15 of the stress.
  CHECK(rock.friction_angle(1e-100) == near(90_deg, 1e-15));
}

TEST_CASE("Hobbs curves obey the axioms in any units") {
  CHECK(to_text(criterion_violations(Hobbs{}, 300_MPa)) == "");
  const Hobbs soft{.compressive_strength = 2_MPa, .factor = 0.3, .exponent = 0.2, .tension = 2_MPa};
  CHECK(to_text(criterion_violations(soft, 2_MPa)) == "");
  CHECK(to_text(criterion_unit_violations(
            Hobbs{}, Hobbs{.compressive_strength = 300, .tension = 12})) == "");
}

TEST_CASE("Hobbs parameters that break a rule are named") {
  const auto message = [](const Hobbs& rock) { return test::message_of([&] { rock.validate(); }); };
  CHECK(message({}).empty());
  CHECK(message({.compressive_strength = 0}) ==
        "Hobbs.compressive_strength = 0: must be a finite number above 0");
  CHECK(message({.factor = -1}) == "Hobbs.factor = -1: must be a finite number above 0");
  CHECK(message({.exponent = 1.5}) == "Hobbs.exponent = 1.5: must lie in (0, 1]");
  CHECK(message({.exponent = 0}) == "Hobbs.exponent = 0: must lie in (0, 1]");
  CHECK(message({.tension = 0}) == "Hobbs.tension = 0: must be a finite number above 0");
  CHECK(message({.tension = 301e6}) ==
        "Hobbs.tension = 3.01e+08: must not exceed the compressive strength");
}
