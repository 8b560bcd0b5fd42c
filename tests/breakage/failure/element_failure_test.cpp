// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/failure/element_failure.hpp>

#include <doctest/doctest.h>
#include <limits>

#include <cmath>
#include <numbers>
#include <string>

#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/criterion/mohr_coulomb.hpp>
#include <riprap/breakage/criterion/rankine.hpp>
#include <riprap/breakage/failure/failure_count.hpp>
#include <riprap/core/units.hpp>
#include <support/near.hpp>

using namespace riprap;
using riprap::test::near;
using riprap::test::near_relative;

namespace {

// Principal stresses along axes turned by `angle`.
Stress2 principal_state(double major, double minor, double angle) {
  return Stress2{major, minor, 0}.rotated(Rotation::from_angle(angle));
}

// Normal stress on the plane that runs along `direction`, and the shear stress in it.
struct Traction {
  double normal;
  double shear;
};
Traction traction_on(const Stress2& s, const Vec2& direction) {
  const Vec2 n = perpendicular(direction);
  const Vec2 t{s.s11 * n.x() + s.s12 * n.y(), s.s12 * n.x() + s.s22 * n.y()};
  return {t.dot(n), t.dot(direction)};
}

constexpr double angles[] = {0, 0.3, 0.7853981633974483, 1.2345, 2.9, -1.1};

}  // namespace

TEST_CASE("safety factors of eq. 2 for Table 1's rock") {
  const HoekBrown rock;
  for (const double angle : angles) {
    CAPTURE(angle);
    // 12 MPa of tensile strength against 15 MPa of tension.
    const ElementFailure torn = evaluate(rock, principal_state(0, -15_MPa, angle));
    CHECK(torn.mode == FailureMode::tension);
    CHECK(torn.safety_factor == near(0.8, 1e-14));
    // 300 MPa of uniaxial strength against 400 and against 150 MPa. Round-off in the minor stress
    // is multiplied by the slope of the curve at zero, 13.5.
    const ElementFailure crushed = evaluate(rock, principal_state(400_MPa, 0, angle));
    CHECK(crushed.mode == FailureMode::shear);
    CHECK(crushed.safety_factor == near(0.75, 1e-14));
    const ElementFailure sound = evaluate(rock, principal_state(150_MPa, 0, angle));
    CHECK(sound.mode == FailureMode::intact);
    CHECK(sound.safety_factor == near(2, 1e-14));
    // Confinement of 10 MPa takes 416.2 MPa.
    const ElementFailure confined = evaluate(rock, principal_state(520_MPa, 10_MPa, angle));
    CHECK(confined.mode == FailureMode::shear);
    CHECK(confined.safety_factor == near_relative(416.2019 / 520, 2e-7));
  }
}

TEST_CASE("an element exactly at its strength has failed, with a safety factor of one") {
  const HoekBrown rock;
  const ElementFailure tension = evaluate(rock, Stress2{0, -12_MPa, 0});
  CHECK(tension.mode == FailureMode::tension);
  CHECK(tension.safety_factor == 1);
  const ElementFailure shear = evaluate(rock, Stress2{300_MPa, 0, 0});
  CHECK(shear.mode == FailureMode::shear);
  CHECK(shear.safety_factor == 1);
  CHECK_FALSE(evaluate(rock, Stress2{299.999_MPa, 0, 0}).failed());
  CHECK_FALSE(evaluate(rock, Stress2{0, -11.97_MPa, 0}).failed());
}

TEST_CASE("a cut-off in tension holds where the shear limit is still far away") {
  const MohrCoulomb soil{.cohesion = 10_MPa, .angle = 30_deg, .tension = 5_MPa};
  REQUIRE(soil.major_stress_at_failure(-5_MPa) > 19_MPa);
  const ElementFailure at = evaluate(soil, Stress2{0, -5_MPa, 0});
  CHECK(at.mode == FailureMode::tension);
  CHECK(at.safety_factor == 1);
  CHECK(evaluate(soil, Stress2{0, -8_MPa, 0}).safety_factor == 0.625);
  CHECK_FALSE(evaluate(soil, Stress2{0, -4.999_MPa, 0}).failed());
}

TEST_CASE("tension comes before shear") {
  // Both rules hold: sigma_3 is beyond the tensile strength and sigma_1 above any limit.
  const ElementFailure element = evaluate(HoekBrown{}, Stress2{900_MPa, -24_MPa, 0});
  CHECK(element.mode == FailureMode::tension);
  CHECK(element.safety_factor == 0.5);
}

TEST_CASE("an intact element without compression has no ratio") {
  const HoekBrown rock;
  for (const Stress2& stress :
       {Stress2{0, 0, 0}, Stress2{0, -5_MPa, 0}, Stress2{-3_MPa, -5_MPa, 0}}) {
    const ElementFailure element = evaluate(rock, stress);
    CHECK(element.mode == FailureMode::intact);
    CHECK(std::isinf(element.safety_factor));
    CHECK(element.safety_factor > 0);
    CHECK(element.weight() == 0);
  }
}

TEST_CASE("next to the tensile strength sigma_1f is negative and failure counts as tension") {
  const HoekBrown rock;
  // sigma_1f = 0 at sigma_3 = -12 + 12 x MPa with 12 x + 300 sqrt(x) = 12.
  const double root = (-300 + std::sqrt(300.0 * 300 + 4 * 12 * 12)) / 24;
  const double edge = (-12 + 12 * root * root) * 1e6;
  CHECK(edge == near(-11.98_MPa, 0.005_MPa));
  CHECK(rock.major_stress_at_failure(edge) == near(0, 1e-2));

  for (const double minor : {-11.9999_MPa, -11.99_MPa, -11.985_MPa}) {
    for (const double major : {0.0, 3_MPa}) {
      CAPTURE(minor);
      REQUIRE(rock.major_stress_at_failure(minor) < 0);
      const ElementFailure element = evaluate(rock, Stress2{major, minor, 0});
      CHECK(element.mode == FailureMode::tension);
      // 12 / 11.99 would say that it stands: a failed element never has more than one.
      CHECK(element.safety_factor == 1);
      CHECK(element.weight() == 1);
    }
    // Tension all round stays below the curve.
    CHECK_FALSE(evaluate(rock, Stress2{0.999 * minor, minor, 0}).failed());
  }
  // Outside the band, on the side of compression, the same element is intact or shears.
  CHECK_FALSE(evaluate(rock, Stress2{0, -11.97_MPa, 0}).failed());
  const ElementFailure sheared = evaluate(rock, Stress2{20_MPa, -11.97_MPa, 0});
  CHECK(sheared.mode == FailureMode::shear);
  CHECK(sheared.safety_factor > 0);
  CHECK(sheared.safety_factor < 1);
}

TEST_CASE("failed elements have safety factors in (0, 1], intact ones above 1") {
  const HoekBrown rock;
  int failed = 0;
  int intact = 0;
  for (double minor = -30_MPa; minor < 60_MPa; minor += 0.731_MPa)
    for (double major = minor; major < 900_MPa; major += 7.77_MPa) {
      const ElementFailure element = evaluate(rock, Stress2{major, minor, 0});
      ++(element.failed() ? failed : intact);
      CHECK(element.safety_factor > 0);
      CHECK((element.safety_factor <= 1) == element.failed());
    }
  CHECK(failed > 1000);
  CHECK(intact > 1000);
}

TEST_CASE("the weight of an element is one over its safety factor") {
  CHECK(evaluate(HoekBrown{}, Stress2{600_MPa, 0, 0}).weight() == 2);
  CHECK(evaluate(HoekBrown{}, Stress2{0, -48_MPa, 0}).weight() == 4);
}

TEST_CASE("a tensile crack runs along the major direction, across the largest tension") {
  const HoekBrown rock;
  for (const double angle : angles) {
    CAPTURE(angle);
    const Stress2 stress = principal_state(2_MPa, -20_MPa, angle);
    const FailurePlanes planes = failure_planes(rock, stress, FailureMode::tension);
    REQUIRE(planes.count == 1);
    const Vec2 crack = planes.directions[0];
    CHECK(crack.norm() == near(1, 1e-15));
    CHECK(std::abs(crack.dot(Vec2{std::cos(angle), std::sin(angle)})) == near(1, 1e-14));
    // The plane carries the whole tension and no shear.
    CHECK(traction_on(stress, crack).normal == near(-20_MPa, 1e-7));
    CHECK(traction_on(stress, crack).shear == near(0, 1e-7));
  }
}

TEST_CASE("for phi = 30 degrees shear planes lie 30 degrees off the axis and 60 apart") {
  const MohrCoulomb soil{.cohesion = 10_MPa, .angle = 30_deg, .tension = 5_MPa};
  for (const double angle : angles) {
    CAPTURE(angle);
    const Stress2 stress = principal_state(184_MPa, 20_MPa, angle);
    const FailurePlanes planes = failure_planes(soil, stress, FailureMode::shear);
    REQUIRE(planes.count == 2);
    const Vec2 axis{std::cos(angle), std::sin(angle)};
    for (const Vec2& plane : planes.span()) {
      CHECK(plane.norm() == near(1, 1e-15));
      CHECK(std::abs(plane.dot(axis)) == near(std::cos(30_deg), 1e-14));
    }
    CHECK(std::abs(planes.directions[0].dot(planes.directions[1])) ==
          near(std::cos(60_deg), 1e-14));
    CHECK(planes.angle_to(axis) == near(30_deg, 1e-14));
    CHECK(planes.angle_to(perpendicular(axis)) == near(60_deg, 1e-14));
  }
}

TEST_CASE("on a shear plane of a state at failure, tau = c + sigma tan phi") {
  for (const double phi : {10_deg, 30_deg, 55_deg}) {
    const MohrCoulomb soil{.cohesion = 10_MPa, .angle = phi, .tension = 1_MPa};
    for (const double minor : {-1_MPa, 0_MPa, 40_MPa}) {
      const Stress2 stress = principal_state(soil.major_stress_at_failure(minor), minor, 0.4);
      const FailurePlanes planes = failure_planes(soil, stress, FailureMode::shear);
      REQUIRE(planes.count == 2);
      for (const Vec2& plane : planes.span()) {
        const Traction t = traction_on(stress, plane);
        CHECK(std::abs(t.shear) == near_relative(soil.cohesion + t.normal * std::tan(phi), 1e-12));
      }
    }
  }
}

TEST_CASE("shear planes of Hoek-Brown rock follow the chosen friction angle at sigma_3") {
  const Stress2 stress = principal_state(500_MPa, 10_MPa, 1);
  const Vec2 axis{std::cos(1.0), std::sin(1.0)};
  const FailurePlanes fit = failure_planes(HoekBrown{}, stress, FailureMode::shear);
  // Angles of the table are printed with four digits after the point.
  CHECK(fit.angle_to(axis) == near(45_deg - 0.5 * 61.7325_deg, 1e-6));
  const FailurePlanes tangent =
      failure_planes(HoekBrown{.angle = HoekBrown::Angle::tangent}, stress, FailureMode::shear);
  CHECK(tangent.angle_to(axis) == near(45_deg - 0.5 * 55.2790_deg, 1e-6));
}

TEST_CASE("failure planes turn with the stress") {
  const HoekBrown rock;
  const Stress2 stress{350_MPa, 20_MPa, 60_MPa};
  const FailurePlanes before = failure_planes(rock, stress, FailureMode::shear);
  for (const double angle : angles) {
    const Rotation turn = Rotation::from_angle(angle);
    const FailurePlanes after = failure_planes(rock, stress.rotated(turn), FailureMode::shear);
    for (const Vec2& plane : before.span()) CHECK(after.angle_to(turn * plane) == near(0, 1e-13));
  }
}

TEST_CASE("an intact element has no failure planes, and every direction is 90 degrees off") {
  const FailurePlanes none = failure_planes(HoekBrown{}, Stress2{1_MPa, 0, 0}, FailureMode::intact);
  CHECK(none.count == 0);
  CHECK(none.span().empty());
  CHECK(none.angle_to(Vec2{1, 0}) == 0.5 * std::numbers::pi);
}

TEST_CASE("the angle to a plane is that of undirected lines") {
  FailurePlanes planes;
  planes.count = 1;  // along axis 1
  for (const double angle : {0.0, 0.2, 1.0, 1.5})
    for (const double sign : {1.0, -1.0}) {
      const Vec2 d{std::cos(angle), sign * std::sin(angle)};
      CHECK(planes.angle_to(d) == near(angle, 1e-15));
      CHECK(planes.angle_to(-d) == near(angle, 1e-15));
    }
}

TEST_CASE("failure modes have names") {
  CHECK(std::string(to_text(FailureMode::intact)) == "intact");
  CHECK(std::string(to_text(FailureMode::tension)) == "tension");
  CHECK(std::string(to_text(FailureMode::shear)) == "shear");
}

TEST_CASE("a stress or strength that is not a number is refused, never intact") {
  constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {nan_value, infinity, -infinity})
    for (const Stress2& stress : {Stress2{bad, 0, 0}, Stress2{1e6, bad, 0}, Stress2{1e6, 2e6, bad},
                                  Stress2{bad, bad, 0}, Stress2{bad, -bad, 0}}) {
      CAPTURE(bad);
      CHECK_THROWS_AS((void)evaluate(HoekBrown{}, stress), InvalidInput);
    }
  CHECK_THROWS_WITH_AS((void)evaluate(HoekBrown{}, {1e6, nan_value, 0}),
                       "evaluate: stress (1e+06, nan, 0) Pa: must be finite", InvalidInput);
  struct NoStrength {
    double major_stress_at_failure(double) const { return std::nan(""); }
    double tensile_strength() const { return 12e6; }
  };
  CHECK_THROWS_WITH_AS((void)evaluate(NoStrength{}, {2e6, 1e6, 0}),
                       "criterion: major_stress_at_failure(1e+06 Pa) = nan: must be a number",
                       InvalidInput);
  ElementStress stress;
  stress.reset(3);
  stress.set(1, {0, nan_value, 0});
  CHECK_THROWS_AS((void)count_failures(HoekBrown{}, stress), InvalidInput);
}

TEST_CASE("the safety factor keeps its digits beside a large major stress") {
  const HoekBrown rock;
  // Tension of 1845 Pa across 38.6 MPa: a criterion with that tensile strength fails exactly.
  const Rankine weak{.tension = 1845};
  CHECK(evaluate(weak, {3.86e7, -1845, 0}).safety_factor == 1);
  CHECK(evaluate(weak, {3.86e7, -1845, 0}).mode == FailureMode::tension);
  CHECK(evaluate(rock, {3.86e7, -1845, 0}).safety_factor ==
        near_relative(rock.major_stress_at_failure(-1845) / 3.86e7, 1e-15));
}
