// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/criterion/rock_mass.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/conformance/criterion.hpp>
#include <riprap/core/units.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using riprap::test::near_relative;

TEST_CASE("rock with a Geological Strength Index of 100 is intact") {
  for (const double disturbance : {0.0, 0.5, 1.0}) {
    const HoekBrown rock = RockMass{.gsi = 100, .disturbance = disturbance}.hoek_brown();
    CHECK(rock.compressive_strength == HoekBrown{}.compressive_strength);
    CHECK(rock.m_b == HoekBrown{}.m_b);
    CHECK(rock.s == HoekBrown{}.s);
    CHECK(rock.a_b == HoekBrown{}.a_b);
  }
}

TEST_CASE("the parameters of a rock mass follow from the relations of 2002") {
  // Computed in 30 digits; half a unit of the last printed digit.
  struct Row {
    double gsi;
    double m_i;
    double disturbance;
    double m_b;
    double s;
    double a_b;
  };
  for (const Row& row : {Row{75, 19.1, 0, 7.82114679, 0.062176524, 0.500910886},
                         Row{45, 10, 0, 1.40256034, 0.0022180849, 0.508085739},
                         Row{45, 10, 1, 0.19671755, 0.000104464144, 0.508085739},
                         Row{60, 25, 0.7, 2.77617374, 0.003036343, 0.502840501},
                         Row{0, 25, 0, 0.702891494, 1.49453385e-5, 0.666454561}}) {
    CAPTURE(row.gsi);
    const HoekBrown rock =
        RockMass{.m_i = row.m_i, .gsi = row.gsi, .disturbance = row.disturbance}.hoek_brown();
    CHECK(rock.m_b == near_relative(row.m_b, 3e-8));
    CHECK(rock.s == near_relative(row.s, 1e-8));
    CHECK(rock.a_b == near_relative(row.a_b, 1e-9));
    CHECK_NOTHROW(rock.validate());
  }
}

TEST_CASE("rock masses obey the axioms, down to the poorest") {
  for (const double gsi : {0.0, 20.0, 60.0}) {
    const HoekBrown rock = RockMass{.gsi = gsi, .disturbance = 0.5}.hoek_brown();
    const double uniaxial = 300_MPa * std::pow(rock.s, rock.a_b);
    CHECK(to_text(criterion_violations(rock, uniaxial)) == "");
  }
}

TEST_CASE("parameters of a rock mass that break a rule are named") {
  const auto message = [](const RockMass& rock) {
    return test::message_of([&] { (void)rock.hoek_brown(); });
  };
  CHECK(message({}).empty());
  CHECK(message({.compressive_strength = 0}) ==
        "RockMass.compressive_strength = 0: must be a finite number above 0");
  CHECK(message({.m_i = -1}) == "RockMass.m_i = -1: must be a finite number above 0");
  CHECK(message({.gsi = 101}) == "RockMass.gsi = 101: must lie in [0, 100]");
  CHECK(message({.gsi = -1}) == "RockMass.gsi = -1: must lie in [0, 100]");
  CHECK(message({.disturbance = 2}) == "RockMass.disturbance = 2: must lie in [0, 1]");
}
