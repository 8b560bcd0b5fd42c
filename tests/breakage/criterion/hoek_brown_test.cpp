// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/criterion/hoek_brown.hpp>

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

#include <riprap/conformance/criterion.hpp>
#include <riprap/core/units.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::near_relative;

namespace {

constexpr double degree = std::numbers::pi / 180;

struct Row {
  double x;
  double expected;
};

}  // namespace

TEST_CASE("the Hoek-Brown curve of Table 1's rock passes through the computed points") {
  // sigma_1f = sigma_3 + 300 sqrt(25 sigma_3 / 300 + 1) in MPa, by pocket calculator.
  const HoekBrown rock;
  for (const Row& row :
       {Row{-12, -12}, Row{-6, 206.1320}, Row{0, 300}, Row{5, 362.0714}, Row{10, 416.2019},
        Row{25, 551.7827}, Row{50, 731.9091}, Row{100, 1016.5151}}) {
    CAPTURE(row.x);
    // Half a unit of the last printed digit.
    CHECK(rock.major_stress_at_failure(row.x * 1e6) == near(row.expected * 1e6, 51));
  }
}

TEST_CASE("the tensile strength of Table 1's rock is 12 MPa and its uniaxial strength 300 MPa") {
  const HoekBrown rock;
  CHECK(rock.tensile_strength() == near_relative(12_MPa, 1e-15));
  CHECK(rock.major_stress_at_failure(0) == near_relative(300_MPa, 1e-15));
  // Where the curve ends sigma_1f = sigma_3; beyond it there is no curve.
  CHECK(rock.major_stress_at_failure(-12_MPa) == -12_MPa);
  CHECK(rock.major_stress_at_failure(-13_MPa) == -13_MPa);
}

TEST_CASE("the equivalent friction angle needs sigma_3 over sigma_c") {
  // Eq. 7 with a = 0.5, S = 1 (Hoek, Carranza-Torres and Corkum 2002, applied at a point).
  const HoekBrown rock;
  for (const Row& row : {Row{-6, 69.0606}, Row{0, 65.3800}, Row{5, 63.3338}, Row{10, 61.7325},
                         Row{25, 58.2807}, Row{50, 54.5671}, Row{100, 49.9949}}) {
    CAPTURE(row.x);
    CHECK(rock.friction_angle(row.x * 1e6) / degree == near(row.expected, 5.1e-5));
  }
}

TEST_CASE("the tangent friction angle is that of the slope of the curve") {
  const HoekBrown rock{.angle = HoekBrown::Angle::tangent};
  for (const Row& row : {Row{0, 59.5497}, Row{10, 55.2790}, Row{50, 47.1644}}) {
    CAPTURE(row.x);
    CHECK(rock.friction_angle(row.x * 1e6) / degree == near(row.expected, 5.1e-5));
  }
  for (double a_b : {0.5, 0.65}) {
    const HoekBrown other{.s = 0.3, .a_b = a_b, .angle = HoekBrown::Angle::tangent};
    for (const double minor : {-2_MPa, 0_MPa, 7_MPa, 90_MPa}) {
      const double h = 1_kPa;
      const double slope =
          (other.major_stress_at_failure(minor + h) - other.major_stress_at_failure(minor - h)) /
          (2 * h);
      // Central difference: curvature error (h / scale)^2 ~ 1e-6, round-off ~ 1e-10.
      CHECK(other.friction_angle(minor) == near(std::asin((slope - 1) / (slope + 1)), 1e-6));
    }
  }
}

TEST_CASE("the equivalent angle lies 5 to 8 degrees above the tangent") {
  const HoekBrown fit;
  const HoekBrown tangent{.angle = HoekBrown::Angle::tangent};
  for (const double minor : {-6_MPa, 0_MPa, 5_MPa, 10_MPa, 25_MPa, 50_MPa, 100_MPa}) {
    const double gap = (fit.friction_angle(minor) - tangent.friction_angle(minor)) / degree;
    CHECK(gap > 5);
    CHECK(gap < 8);
  }
}

TEST_CASE("at and beyond the tensile strength the friction angle is 90 degrees") {
  for (const auto angle : {HoekBrown::Angle::equivalent, HoekBrown::Angle::tangent}) {
    const HoekBrown rock{.angle = angle};
    CHECK(rock.friction_angle(-12_MPa) == 0.5 * std::numbers::pi);
    CHECK(rock.friction_angle(-20_MPa) == 0.5 * std::numbers::pi);
  }
}

TEST_CASE("jointed rock has the strengths S sigma_c / m and sigma_c S^a") {
  const HoekBrown rock{.compressive_strength = 80_MPa, .m_b = 4, .s = 0.09, .a_b = 0.6};
  CHECK(rock.tensile_strength() == near_relative(1.8_MPa, 1e-14));
  CHECK(rock.major_stress_at_failure(0) ==
        near_relative(80_MPa * std::exp(0.6 * std::log(0.09)), 1e-14));
  CHECK(rock.major_stress_at_failure(10_MPa) ==
        near_relative(10_MPa + 80_MPa * std::exp(0.6 * std::log(0.59)), 1e-14));
}

TEST_CASE("with a = 1 the Hoek-Brown curve is a straight line of slope 1 + m") {
  const HoekBrown line{
      .compressive_strength = 100_MPa, .m_b = 3, .a_b = 1, .angle = HoekBrown::Angle::tangent};
  for (const double minor : {-10_MPa, 0_MPa, 40_MPa}) {
    CHECK(line.major_stress_at_failure(minor) == near(4 * minor + 100_MPa, 1e-6));
    CHECK(line.friction_angle(minor) == near(std::asin(3.0 / 5), 1e-14));
  }
}

TEST_CASE("the square root and the power give the same curve") {
  const HoekBrown by_root;
  HoekBrown by_power;
  by_power.a_b = std::nextafter(0.5, 1.0);
  for (const double minor : {-11_MPa, 0_MPa, 33_MPa})
    CHECK(by_power.major_stress_at_failure(minor) ==
          near_relative(by_root.major_stress_at_failure(minor), 1e-14));
}

TEST_CASE("the Hoek-Brown criterion does not depend on the unit of stress") {
  const HoekBrown pascal{.compressive_strength = 300e6, .a_b = 0.55};
  const HoekBrown megapascal{.compressive_strength = 300, .a_b = 0.55};
  for (const double minor : {-7.0, 0.0, 21.0}) {
    CHECK(pascal.major_stress_at_failure(minor * 1e6) ==
          near_relative(megapascal.major_stress_at_failure(minor) * 1e6, 1e-14));
    CHECK(pascal.friction_angle(minor * 1e6) ==
          near_relative(megapascal.friction_angle(minor), 1e-14));
  }
}

TEST_CASE("Hoek-Brown curves rise at least as fast as sigma_3") {
  CHECK(to_text(criterion_violations(HoekBrown{}, 300_MPa)) == "");
  const HoekBrown tangent{.angle = HoekBrown::Angle::tangent};
  CHECK(to_text(criterion_violations(tangent, 300_MPa)) == "");
  const HoekBrown jointed{.compressive_strength = 40_MPa, .m_b = 8, .s = 0.2, .a_b = 0.51};
  CHECK(to_text(criterion_violations(jointed, 40_MPa * std::pow(0.2, 0.51))) == "");
}

TEST_CASE("Hoek-Brown parameters that break a rule are named") {
  const auto message = [](const HoekBrown& rock) {
    return test::message_of([&] { rock.validate(); });
  };
  CHECK(message({}).empty());
  CHECK(message({.compressive_strength = -3}) ==
        "HoekBrown.compressive_strength = -3: must be a finite number above 0");
  CHECK(message({.m_b = 0}) == "HoekBrown.m_b = 0: must be a finite number above 0");
  CHECK(message({.s = 1.5}) == "HoekBrown.s = 1.5: must lie in (0, 1]");
  CHECK(message({.s = std::nan("")}).starts_with("HoekBrown.s = "));
  CHECK(message({.a_b = 0}) == "HoekBrown.a_b = 0: must lie in (0, 1]");
}
