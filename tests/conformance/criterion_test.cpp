// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <numbers>
#include <support/violated.hpp>

#include <riprap/breakage/criterion/criterion_choice.hpp>
#include <riprap/breakage/criterion/criterion_of_rock.hpp>
#include <riprap/breakage/criterion/franklin.hpp>
#include <riprap/breakage/criterion/griffith.hpp>
#include <riprap/breakage/criterion/hobbs.hpp>
#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/criterion/modified_griffith.hpp>
#include <riprap/breakage/criterion/mohr_coulomb.hpp>
#include <riprap/breakage/criterion/murrell.hpp>
#include <riprap/breakage/criterion/never_fails.hpp>
#include <riprap/breakage/criterion/rankine.hpp>
#include <riprap/breakage/criterion/rock_mass.hpp>
#include <riprap/breakage/criterion/three_principal_stresses.hpp>
#include <riprap/conformance/criterion.hpp>

using namespace riprap;
using test::check_violated;

namespace {

struct Tresca {
  double strength = 300e6;
  double tension = 12e6;
  double major_stress_at_failure(double minor) const { return minor + strength; }
  double tensile_strength() const { return tension; }
};

/// Softer the more it is confined.
struct Flattening {
  double major_stress_at_failure(double minor) const { return 300e6 + 0.9 * minor; }
  double tensile_strength() const { return 12e6; }
};

/// Fails under equal stresses from 50 MPa on.
struct Crushing {
  double major_stress_at_failure(double minor) const { return std::min(minor + 300e6, 50e6); }
  double tensile_strength() const { return 12e6; }
};

/// Its curve ends where the root becomes imaginary, short of its tensile strength.
struct Unfinished : HoekBrown {
  double major_stress_at_failure(double minor) const {
    return minor + compressive_strength * std::sqrt(25 * minor / compressive_strength + 0.5);
  }
};

/// Feels a stress out of the plane that falls as those in the plane rise.
struct Squeezed : HoekBrown {
  PrincipalValues extreme_stresses(const PrincipalValues& in_plane) const {
    return {in_plane.major, std::min(in_plane.minor, -0.05 * (in_plane.major + in_plane.minor))};
  }
};

/// Feels the major stress in the plane as the smallest.
struct Hydrostatic : HoekBrown {
  PrincipalValues extreme_stresses(const PrincipalValues& in_plane) const {
    return {in_plane.major, in_plane.major};
  }
};

struct GivenAngle : HoekBrown {
  double given = 0;
  double friction_angle(double) const { return given; }
};

}  // namespace

TEST_CASE("the criteria of riprap obey the axioms") {
  CHECK(to_text(criterion_violations(HoekBrown{}, 300e6)) == "");
  CHECK(to_text(criterion_violations(HoekBrown{.angle = HoekBrown::Angle::tangent})) == "");
  CHECK(to_text(criterion_violations(HoekBrown{.m_b = 4, .s = 0.3, .a_b = 0.6})) == "");
  // The printed digits of the default cohesion give it seven of them.
  CHECK(to_text(criterion_violations(MohrCoulomb{}, 300e6)) == "");
  CHECK(to_text(criterion_violations(Rankine{})) == "");
  CHECK(to_text(criterion_violations(RockMass{.gsi = 50}.hoek_brown())) == "");
  CHECK(to_text(criterion_violations(Griffith{}, 8 * 12e6)) == "");
  CHECK(to_text(criterion_violations(ModifiedGriffith{}, 4 * 12e6 * (1 + std::sqrt(2.0)))) == "");
  CHECK(to_text(criterion_violations(Murrell{}, 12 * 12e6)) == "");
  CHECK(to_text(criterion_violations(Hobbs{}, 300e6)) == "");
  CHECK(to_text(criterion_violations(Franklin{}, 300e6)) == "");
  for (const double ratio : {0.0, 0.17, 0.45}) {
    CHECK(to_text(criterion_violations(ThreePrincipalStresses{HoekBrown{}, ratio}, 300e6)) == "");
    CHECK(to_text(criterion_violations(ThreePrincipalStresses{MohrCoulomb{}, ratio}, 300e6)) == "");
    CHECK(to_text(criterion_violations(ThreePrincipalStresses{Rankine{}, ratio})) == "");
  }
  CHECK(to_text(criterion_violations(NeverFails{})) == "");
  using Choice = CriterionChoice<HoekBrown, MohrCoulomb, Rankine, Franklin>;
  CHECK(to_text(criterion_violations(Choice{HoekBrown{}}, 300e6)) == "");
  // Curves that cross: the lower one of both.
  const CriterionOfRock<Choice> rocks{{Choice{HoekBrown{}}, Choice{MohrCoulomb{.tension = 9e6}}}};
  CHECK(to_text(criterion_violations(rocks)) == "");
  const CriterionOfRock out_of_plane{{ThreePrincipalStresses{HoekBrown{}, 0.17},
                                      ThreePrincipalStresses{HoekBrown{.m_b = 9}, 0.3}}};
  CHECK(to_text(criterion_violations(out_of_plane, 300e6)) == "");
  CHECK(to_text(criterion_violations(Choice{MohrCoulomb{}}, 300e6)) == "");
  CHECK(to_text(criterion_violations(Choice{Rankine{}})) == "");
  CHECK(to_text(criterion_violations(Choice{Franklin{}}, 300e6)) == "");
}

TEST_CASE("a user's criterion obeys the axioms") {
  CHECK(to_text(criterion_violations(Tresca{}, 300e6)) == "");
}

TEST_CASE("a criterion without the strengths that it declares is reported") {
  check_violated(criterion_violations(Rankine{.tension = 0}), "the tensile strength is above zero");
  check_violated(criterion_violations(Rankine{.tension = -12e6}),
                 "at the tensile strength the safety factor is 1");
  check_violated(criterion_violations(Griffith{}, 300e6),
                 "at the uniaxial compressive strength the safety factor is 1");
}

TEST_CASE("a criterion with an impossible curve is reported") {
  check_violated(criterion_violations(Flattening{}), "the curve rises at least as fast as sigma_3");
  check_violated(criterion_violations(Crushing{}),
                 "equal stresses fail in tension only: major stress at failure");
  check_violated(criterion_violations(Unfinished{}), "the major stress at failure is a number");
}

TEST_CASE("a criterion by impossible stresses out of the plane is reported") {
  check_violated(criterion_violations(Squeezed{}),
                 "an intact element stays so if its minor stress in the plane rises");
  check_violated(criterion_violations(Hydrostatic{}),
                 "the smallest stress is not above those in the plane");
}

TEST_CASE("a criterion with an impossible friction angle is reported") {
  check_violated(criterion_violations(GivenAngle{{}, -0.1}), "the friction angle is not negative");
  check_violated(criterion_violations(GivenAngle{{}, 0.5 * std::numbers::pi}),
                 "the friction angle is below a right one");
}

TEST_CASE("criteria give the same in millimetres, grams and milliseconds") {
  CHECK(to_text(criterion_unit_violations(HoekBrown{}, HoekBrown{.compressive_strength = 300})) ==
        "");
  CHECK(to_text(criterion_unit_violations(
            MohrCoulomb{}, MohrCoulomb{.cohesion = 32.732684, .tension = 12})) == "");
  CHECK(to_text(criterion_unit_violations(Rankine{}, Rankine{.tension = 12})) == "");
  CHECK(to_text(criterion_unit_violations(NeverFails{}, NeverFails{})) == "");
  CHECK(to_text(criterion_unit_violations(ModifiedGriffith{.friction = 0.6},
                                          ModifiedGriffith{.tension = 12, .friction = 0.6})) == "");
  CHECK(to_text(criterion_unit_violations(Murrell{}, Murrell{.tension = 12})) == "");
  CHECK(to_text(criterion_unit_violations(
            Hobbs{}, Hobbs{.compressive_strength = 300, .tension = 12})) == "");
  CHECK(to_text(criterion_unit_violations(
            Franklin{}, Franklin{.compressive_strength = 300, .tension = 12})) == "");
  using Choice = CriterionChoice<HoekBrown, Rankine>;
  CHECK(to_text(criterion_unit_violations(Choice{Rankine{}}, Choice{Rankine{.tension = 12}})) ==
        "");
  CHECK(to_text(criterion_unit_violations(Griffith{}, Griffith{.tension = 12})) == "");
}

TEST_CASE("a criterion with a stress of its own is reported in other units") {
  check_violated(criterion_unit_violations(Flattening{}, Flattening{}),
                 "the tensile strength is the same in other units");
  check_violated(criterion_unit_violations(Tresca{}, Tresca{.tension = 12}),
                 "the major stress at failure is the same in other units");
  struct AngleOfStress : Griffith {
    double friction_angle(double minor) const { return minor > 5e6 ? 0.5 : 0.6; }
  };
  check_violated(criterion_unit_violations(AngleOfStress{}, AngleOfStress{{.tension = 12}}),
                 "the friction angle is the same in other units");
}
