// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/criterion/franklin.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/breakage/criterion/griffith.hpp>
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

TEST_CASE("the Franklin curve passes through the solutions of his equation") {
  // sigma_1 - sigma_3 = 300^0.2 (sigma_1 + sigma_3)^0.8 in MPa, by bisection in 30 digits.
  const Franklin rock;
  for (const Row& row :
       {Row{-11, 164.660169}, Row{-6, 239.508049}, Row{0, 300}, Row{5, 342.201595},
        Row{10, 380.262428}, Row{25, 480.172485}, Row{50, 621.684891}, Row{100, 862.044724}}) {
    CAPTURE(row.x);
    // Half a unit of the last printed digit.
    CHECK(rock.major_stress_at_failure(row.x * 1e6) == near_relative(row.expected * 1e6, 5e-9));
  }
}

TEST_CASE("from the difference of the stresses to the minor one there is a closed form") {
  for (const double b : {0.5, 0.55, 0.7, 0.8, 0.95, 0.999}) {
    CAPTURE(b);
    const double end = std::pow(b, b / (1 - b));
    for (const double share : {1e-3, 0.01, 0.5, 1.0, 3.0, 100.0, 1e6}) {
      CAPTURE(share);
      // (sigma_1 - sigma_3) / sigma_c, and sigma_3 / sigma_c from it.
      const double difference = end * (1 + share);
      const double minor = 0.5 * (std::pow(difference, 1 / b) - difference);
      const Franklin rock{.compressive_strength = 1, .exponent = b, .tension = 1};
      // Round-off of the larger term over the slope of the closed form, and of the sum.
      const double slope = 0.5 * (std::pow(difference, 1 / b - 1) / b - 1);
      const double tolerance =
          4e-16 * (std::pow(difference, 1 / b) / slope + difference + std::abs(minor));
      CHECK(rock.major_stress_at_failure(minor) == near(minor + difference, 2 * tolerance));
    }
  }
}

TEST_CASE("with exponent 1/2 the Franklin curve is Griffith's") {
  const Franklin rock{.compressive_strength = 96_MPa, .exponent = 0.5};
  CHECK(rock.end() == 12_MPa);
  CHECK_NOTHROW(rock.validate());
  for (const double minor : {-12_MPa, -11_MPa, -1_MPa, 0_MPa, 1_MPa, 30_MPa, 1e4_MPa}) {
    CHECK(rock.major_stress_at_failure(minor) ==
          near_relative(Griffith{}.major_stress_at_failure(minor), 1e-15));
    CHECK(rock.friction_angle(minor) == near(Griffith{}.friction_angle(minor), 2e-15));
  }
}

TEST_CASE("Franklin rock has the strengths that it is given") {
  const Franklin rock{.compressive_strength = 80_MPa, .tension = 3_MPa};
  CHECK(rock.tensile_strength() == 3_MPa);
  CHECK(rock.major_stress_at_failure(0) == 80_MPa);
  // Beyond it there is no curve.
  CHECK(rock.major_stress_at_failure(-3.1_MPa) == -3.1_MPa);
  CHECK(rock.friction_angle(-3.1_MPa) == 90_deg);
}

TEST_CASE("at its end the Franklin curve is vertical") {
  Franklin rock;
  // (1 - B) B^(B / (1 - B)) / 2 = 0.1 * 0.8^4.
  CHECK(rock.end() == near_relative(12.288_MPa, 1e-15));
  rock.tension = rock.end();
  CHECK_NOTHROW(rock.validate());
  // sigma_1 - sigma_3 = 0.8^4 sigma_c; half of the digits are lost where the slope is infinite.
  CHECK(rock.major_stress_at_failure(-rock.end()) ==
        near_relative(0.4096 * 300_MPa - rock.end(), 1e-6));
  CHECK(rock.friction_angle(-rock.end()) == near(90_deg, 1e-3));
}

TEST_CASE("the friction angle of Franklin rock is that of the slope of its curve") {
  const Franklin rock;
  // asin((k - 1) / (k + 1)) by a central difference in 30 digits; half a unit of the last digit.
  for (const Row& row : {Row{-6, 57.257739}, Row{5, 50.982948}, Row{50, 42.913741}})
    CHECK(rock.friction_angle(row.x * 1e6) == near(row.expected * 1_deg, 1e-8));
}

TEST_CASE("Franklin curves obey the axioms in any units") {
  CHECK(to_text(criterion_violations(Franklin{}, 300_MPa)) == "");
  const Franklin to_the_end{.exponent = 0.6, .tension = 27_MPa};
  CHECK(to_text(criterion_violations(to_the_end, 300_MPa)) == "");
  const Franklin steep{.exponent = 0.95, .tension = 2_MPa};
  CHECK(to_text(criterion_violations(steep, 300_MPa)) == "");
  CHECK(to_text(criterion_unit_violations(
            Franklin{}, Franklin{.compressive_strength = 300, .tension = 12})) == "");
}

TEST_CASE("Franklin parameters that break a rule are named") {
  const auto message = [](const Franklin& rock) {
    return test::message_of([&] { rock.validate(); });
  };
  CHECK(message({}).empty());
  CHECK(message({.compressive_strength = -1}) ==
        "Franklin.compressive_strength = -1: must be a finite number above 0");
  CHECK(message({.exponent = 0.4}) == "Franklin.exponent = 0.4: must lie in [0.5, 1)");
  CHECK(message({.exponent = 1}) == "Franklin.exponent = 1: must lie in [0.5, 1)");
  CHECK(message({.tension = 0}) == "Franklin.tension = 0: must be a finite number above 0");
  CHECK(message({.tension = 13e6})
            .starts_with("Franklin.tension = 1.3e+07: must not pass the end of the curve, "));
}
