// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/criterion/concepts.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/breakage/criterion/criterion_choice.hpp>
#include <riprap/breakage/criterion/mohr_coulomb.hpp>
#include <riprap/breakage/failure/element_failure.hpp>
#include <riprap/conformance/criterion.hpp>
#include <riprap/core/units.hpp>
#include <support/archetypes.hpp>
#include <support/near.hpp>

using namespace riprap;
namespace archetype = riprap::test::archetype;
using riprap::test::near;

namespace {

// The smallest criterion: two functions, and no other member. A straight line of
// slope 3, that is c = 10 MPa and phi = 30 degrees.
struct StraightLine {
  double major_stress_at_failure(double minor) const { return 3 * minor + 20e6 * std::sqrt(3.0); }
  double tensile_strength() const { return 5e6; }
};

// A parabola touching sigma_3 = -sigma_t (after Griffith 1924): the slope falls with sigma_3.
struct Parabola {
  double strength = 10e6;
  double major_stress_at_failure(double minor) const {
    return minor + 4 * (strength + std::sqrt(strength * (strength + minor)));
  }
  double tensile_strength() const { return strength; }
};

struct WithoutTensileStrength : archetype::Criterion {
  void tensile_strength(int) const {}
};
struct WithoutCurve : archetype::Criterion {
  void major_stress_at_failure() const {}
};
struct NotConst : archetype::Criterion {
  double tensile_strength() { return 1; }
};
struct ChangesTheStress : archetype::Criterion {
  double major_stress_at_failure(double& minor) const { return minor; }
};
struct AngleIsNotConst : archetype::Criterion {
  double friction_angle(double) { return 0; }
};
struct AngleIsNoNumber : archetype::Criterion {
  Vec2 friction_angle(double) const { return {1, 0}; }
};
struct SaysThatItCanFail : StraightLine {
  static constexpr bool never_fails = false;
};
struct CurveIsNotConst : archetype::Criterion {
  double major_stress_at_failure(double minor) { return minor; }
};
struct CurveIsNoNumber : archetype::Criterion {
  Vec2 major_stress_at_failure(double minor) const { return {minor, 0}; }
};
struct TensionIsNoNumber : archetype::Criterion {
  Vec2 tensile_strength() const { return {1, 0}; }
};
struct AngleChangesTheStress : archetype::Criterion {
  double friction_angle(double& minor) const { return minor; }
};
struct ExtremesAreNotConst : archetype::Criterion {
  PrincipalValues extreme_stresses(const PrincipalValues& in_plane) { return in_plane; }
};
struct ExtremesAreNumbers : archetype::Criterion {
  double extreme_stresses(const PrincipalValues&) const { return 0; }
};
struct ExtremesChangeTheStress : archetype::Criterion {
  PrincipalValues extreme_stresses(PrincipalValues& in_plane) const { return in_plane; }
};

static_assert(Criterion<archetype::Criterion>);
static_assert(!OutOfPlaneCriterion<archetype::Criterion>);
static_assert(Criterion<StraightLine>);
static_assert(Criterion<Parabola>);
static_assert(!Criterion<WithoutTensileStrength>);
static_assert(!Criterion<WithoutCurve>);
static_assert(!Criterion<NotConst>);
static_assert(!Criterion<ChangesTheStress>);
static_assert(!Criterion<AngleIsNotConst>);
static_assert(!Criterion<AngleIsNoNumber>);
static_assert(!Criterion<CurveIsNotConst>);
static_assert(!Criterion<CurveIsNoNumber>);
static_assert(!Criterion<TensionIsNoNumber>);
static_assert(!Criterion<AngleChangesTheStress>);
static_assert(!Criterion<ExtremesAreNotConst>);
static_assert(!Criterion<ExtremesAreNumbers>);
static_assert(!Criterion<ExtremesChangeTheStress>);
static_assert(!never_fails<StraightLine>);
static_assert(!never_fails<SaysThatItCanFail>);

}  // namespace

TEST_CASE("a criterion of two functions gets its friction angle from the slope of its curve") {
  const MohrCoulomb same{.cohesion = 10_MPa, .angle = 30_deg, .tension = 5_MPa};
  for (const double minor : {-5_MPa, 0_MPa, 1_MPa, 80_MPa}) {
    CHECK(StraightLine{}.major_stress_at_failure(minor) ==
          near(same.major_stress_at_failure(minor), 1e-6));
    // A difference over a millionth of the stress: round-off 1e-16 / 1e-6, some ten times that.
    CHECK(friction_angle(StraightLine{}, minor) == near(same.friction_angle(minor), 3e-9));
  }
}

TEST_CASE("the slope of a curve is taken where the curve is defined") {
  const Parabola curve;
  // d sigma_1f / d sigma_3 = 1 + 2 sqrt(strength / (strength + sigma_3)).
  for (const double minor : {-9_MPa, 0_MPa, 30_MPa}) {
    const double slope = 1 + 2 * std::sqrt(curve.strength / (curve.strength + minor));
    // One-sided: half of step times curvature, here below 1e-5 of the slope.
    CHECK(friction_angle(curve, minor) == near(friction_angle_from_slope(slope), 1e-5));
  }
  // At the tensile strength the slope is infinite and on the other side there is no curve.
  const double steepest = friction_angle(curve, -curve.strength);
  CHECK(steepest > 85_deg);
  CHECK(steepest <= 90_deg);
}

TEST_CASE("sin phi = (k - 1) / (k + 1)") {
  CHECK(friction_angle_from_slope(1) == 0);
  CHECK(friction_angle_from_slope(3) == near(30_deg, 1e-15));
  CHECK(friction_angle_from_slope(1e20) == near(90_deg, 1e-9));
}

TEST_CASE("a criterion of two functions goes through the whole evaluation") {
  // 2 c sqrt(k), and sigma_1f at sigma_3 = 0.
  CHECK(to_text(criterion_violations(StraightLine{}, 20e6 * std::sqrt(3.0))) == "");
  CHECK(to_text(criterion_violations(Parabola{}, 8 * 10e6)) == "");
  const Stress2 stress{40_MPa, 0, 0};
  const ElementFailure element = evaluate(StraightLine{}, stress);
  CHECK(element.mode == FailureMode::shear);
  CHECK(element.safety_factor == near(std::sqrt(3.0) / 2, 1e-14));
  const FailurePlanes planes = failure_planes(StraightLine{}, stress, element.mode);
  REQUIRE(planes.count == 2);
  CHECK(planes.angle_to(Vec2{std::cos(30_deg), std::sin(30_deg)}) == near(0, 3e-9));
  // Also as a member of a run-time choice.
  const CriterionChoice<MohrCoulomb, StraightLine> choice{StraightLine{}};
  CHECK(choice.friction_angle(7_MPa) == friction_angle(StraightLine{}, 7_MPa));
  CHECK_NOTHROW(choice.validate());
}
