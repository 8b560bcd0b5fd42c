// SPDX-License-Identifier: BSL-1.0
#include <riprap/breakage/criterion/three_principal_stresses.hpp>

#include <doctest/doctest.h>

#include <cmath>

#include <riprap/breakage/criterion/criterion_choice.hpp>
#include <riprap/breakage/criterion/hoek_brown.hpp>
#include <riprap/breakage/criterion/mohr_coulomb.hpp>
#include <riprap/breakage/criterion/never_fails.hpp>
#include <riprap/breakage/failure/failure_count.hpp>
#include <riprap/conformance/acceleration.hpp>
#include <riprap/core/units.hpp>
#include <riprap/stress/plane_state/plane_strain.hpp>
#include <support/brazilian_disc.hpp>
#include <support/loaded_particle.hpp>
#include <support/near.hpp>

using namespace riprap;
using test::near;

namespace {

// k = 3 and 2 c sqrt(k) = 60 MPa: sigma_1f = 3 sigma_3 + 60 MPa.
const MohrCoulomb soil{
    .cohesion = 60_MPa / (2 * std::sqrt(3.0)), .angle = 30_deg, .tension = 5_MPa};
const ThreePrincipalStresses plane_stress{soil};
const ThreePrincipalStresses plane_strain{soil, 0.2};

static_assert(OutOfPlaneCriterion<ThreePrincipalStresses<MohrCoulomb>>);
static_assert(!never_fails<ThreePrincipalStresses<MohrCoulomb>>);
static_assert(never_fails<ThreePrincipalStresses<NeverFails>>);

void check_failure(const ElementFailure& found, FailureMode mode, double safety_factor) {
  CHECK(found.mode == mode);
  CHECK(found.safety_factor == near(safety_factor, 1e-14));
}

}  // namespace

TEST_CASE("in plane stress the smallest stress under compression from two sides is zero") {
  // 66 MPa against 60 at sigma_3 = 0; in the plane alone against 3 * 30 + 60 = 150 MPa.
  const Stress2 pressed{66_MPa, 30_MPa, 0};
  check_failure(evaluate(plane_stress, pressed), FailureMode::shear, 60.0 / 66);
  check_failure(evaluate(soil, pressed), FailureMode::intact, 150.0 / 66);
  // Equal pressures fail at the uniaxial strength.
  check_failure(evaluate(plane_stress, {60.1_MPa, 60.1_MPa, 0}), FailureMode::shear, 60 / 60.1);
  CHECK_FALSE(evaluate(plane_stress, {59.9_MPa, 59.9_MPa, 0}).failed());
}

TEST_CASE("in plane stress nothing changes where the stresses in the plane differ in sign") {
  // 3 * (-4) + 60 = 48 MPa.
  const Stress2 split{50_MPa, -4_MPa, 0};
  check_failure(evaluate(plane_stress, split), FailureMode::shear, 0.96);
  check_failure(evaluate(soil, split), FailureMode::shear, 0.96);
  check_failure(evaluate(plane_stress, {10_MPa, -8_MPa, 0}), FailureMode::tension, 0.625);
}

TEST_CASE("in plane stress the largest stress under tension from two sides is zero") {
  check_failure(evaluate(plane_stress, {-1_MPa, -8_MPa, 0}), FailureMode::tension, 0.625);
  const ElementFailure intact = evaluate(plane_stress, {-1_MPa, -4_MPa, 0});
  CHECK(intact.mode == FailureMode::intact);
  CHECK(std::isinf(intact.safety_factor));
  // Where the line meets sigma_1 = 0, at -20 MPa, before a cut-off in tension beyond.
  const ThreePrincipalStresses uncut{
      MohrCoulomb{.cohesion = soil.cohesion, .angle = soil.angle, .tension = 25_MPa}};
  CHECK_FALSE(evaluate(uncut, {-19_MPa, -19.9_MPa, 0}).failed());
  check_failure(evaluate(uncut, {-19_MPa, -20.1_MPa, 0}), FailureMode::tension, 1);
}

TEST_CASE("in plane strain the stress out of the plane is nu times the sum of those in it") {
  // nu (90 + 60) = 30 MPa < 60: 3 * 30 + 60 = 150 against 90 MPa; in the plane alone 240.
  check_failure(evaluate(plane_strain, {90_MPa, 60_MPa, 0}), FailureMode::intact, 150.0 / 90);
  // nu (200 + 50) = 50 MPa, that in the plane: the same.
  check_failure(evaluate(plane_strain, {200_MPa, 50_MPa, 0}), FailureMode::intact, 210.0 / 200);
  // nu (300 + 50) = 70 MPa lies between.
  check_failure(evaluate(plane_strain, {300_MPa, 50_MPa, 0}), FailureMode::shear, 0.7);
  // Equal pressures p: p against 3 * 0.4 p + 60 MPa never fail, but do with nu = 0.1, where
  // 0.6 p + 60 MPa is reached at 150 MPa.
  CHECK_FALSE(evaluate(plane_strain, {5000_MPa, 5000_MPa, 0}).failed());
  const ThreePrincipalStresses stiff{soil, 0.1};
  CHECK_FALSE(evaluate(stiff, {149_MPa, 149_MPa, 0}).failed());
  check_failure(evaluate(stiff, {160_MPa, 160_MPa, 0}), FailureMode::shear, 156.0 / 160);
}

TEST_CASE("the stress out of the plane is that of the plane state") {
  const Rock rock{.young = 70_GPa, .poisson = 0.2, .density = 2500};
  const PrincipalValues in_plane{90_MPa, 60_MPa};
  const Stress2 stress{in_plane.major, in_plane.minor, 0};
  CHECK(plane_strain.extreme_stresses(in_plane).minor ==
        near(PlaneStrain{}.out_of_plane_stress(rock, stress), 1e-8));
  CHECK(plane_stress.extreme_stresses(in_plane).minor ==
        PlaneStress{}.out_of_plane_stress(rock, stress));
}

TEST_CASE("shear planes inclined to the plane meet it across the major direction") {
  const Stress2 pressed{30_MPa, 66_MPa, 0};
  const FailurePlanes inclined = failure_planes(plane_stress, pressed, FailureMode::shear);
  REQUIRE(inclined.count == 1);
  CHECK(inclined.angle_to({1, 0}) == 0);
  // As without, where the smallest stress lies in the plane.
  const Stress2 split{-4_MPa, 50_MPa, 0};
  const FailurePlanes planes = failure_planes(plane_stress, split, FailureMode::shear);
  REQUIRE(planes.count == 2);
  CHECK(planes.directions == failure_planes(soil, split, FailureMode::shear).directions);
}

TEST_CASE("strengths, friction angle and validity are those of the criterion") {
  CHECK(plane_strain.tensile_strength() == 5_MPa);
  CHECK(plane_strain.major_stress_at_failure(7_MPa) == soil.major_stress_at_failure(7_MPa));
  CHECK(friction_angle(plane_strain, 7_MPa) == 30_deg);
  CHECK_NOTHROW(plane_strain.validate());
  CHECK_THROWS_AS(ThreePrincipalStresses{MohrCoulomb{.cohesion = 0}}.validate(), InvalidInput);
  CHECK_THROWS_WITH_AS((ThreePrincipalStresses{soil, 0.5}).validate(),
                       "ThreePrincipalStresses.out_of_plane = 0.5: must lie in [0, 0.5)",
                       InvalidInput);
  CHECK_THROWS_AS((ThreePrincipalStresses{soil, -0.1}).validate(), InvalidInput);
}

TEST_CASE("a choice at run time passes the stresses on to what is chosen") {
  using Choice = CriterionChoice<MohrCoulomb, ThreePrincipalStresses<MohrCoulomb>>;
  const Stress2 pressed{66_MPa, 30_MPa, 0};
  CHECK(evaluate(Choice{plane_stress}, pressed).failed());
  CHECK_FALSE(evaluate(Choice{soil}, pressed).failed());
  static_assert(!OutOfPlaneCriterion<CriterionChoice<MohrCoulomb, HoekBrown>>);
}

namespace {

// Times the loads of the disc at which Rat is 0.4.
template <class C>
double critical_load(const C& criterion, const ElementStress& stress) {
  double low = 0;
  double high = 100;
  while (high - low > 1e-6) {
    const double middle = 0.5 * (low + high);
    ElementStress scaled = stress;
    scaled.values() *= middle;
    (count_failures(criterion, scaled).ratio() >= 0.4 ? high : low) = middle;
  }
  return high;
}

}  // namespace

// The numbers of docs/policies/criterion.md, to their three digits.
TEST_CASE("the Brazilian disc fails at the same load, a disc pressed from four sides at less") {
  const test::BrazilianDisc disc;
  const Mesh mesh = disc.mesh(400);
  const InfluenceOperator op(mesh, ConstantStrainTriangle{}, PlaneStress{}, Rock{}, disc.thickness,
                             false);
  auto loads = disc.loads(mesh);
  const double unit = 1e-3 * disc.force;  // [kN]
  const ElementStress split = test::stress_of(op, loads);
  CHECK(unit * critical_load(HoekBrown{}, split) == near(6.11, 0.01));
  CHECK(unit * critical_load(ThreePrincipalStresses{HoekBrown{}}, split) == near(6.11, 0.01));
  const double across = 0.5 * disc.force;
  for (const double side : {1.0, -1.0})
    loads.push_back(
        {nearest_boundary_point(mesh, {side * disc.radius, 0}), {-side * across, 0}, across});
  const ElementStress pressed = test::stress_of(op, loads);
  CHECK(unit * critical_load(HoekBrown{}, pressed) == near(31.9, 0.1));
  CHECK(unit * critical_load(ThreePrincipalStresses{HoekBrown{}}, pressed) == near(24.9, 0.1));
}

TEST_CASE("particles break by it at the same step and with the same bytes without screening") {
  const auto model = Model{};
  CHECK(to_text(acceleration_violations(model.criterion(ThreePrincipalStresses{HoekBrown{}}))) ==
        "");
  CHECK(to_text(acceleration_violations(
            model.plane_state(PlaneStrain{})
                .criterion(ThreePrincipalStresses{HoekBrown{}, Rock{}.poisson}))) == "");
}
