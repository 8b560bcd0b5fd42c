// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/mean_stress_of_loads.hpp>

#include <doctest/doctest.h>

#include <vector>

#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/mean_stress.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <support/loaded_particle.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using namespace riprap::test;

TEST_CASE("a rectangle between two opposed forces is under force over area times height") {
  const ConvexPolygon polygon = rectangle(0.02, 0.01);
  const std::vector<ContactLoad> loads{{.arm_lab = {0, 0.005}, .force_lab = {0, -3000}},
                                       {.arm_lab = {0, -0.005}, .force_lab = {0, 3000}}};
  const Stress2 mean = mean_stress(loads, polygon.ring(), {0, 0}, 2e-4, 0.016);
  CHECK(mean.s11 == 0);
  CHECK(mean.s22 == near_relative(3000 * 0.01 / (2e-4 * 0.016), 1e-14));
  CHECK(mean.s12 == 0);
}

TEST_CASE("a couple on a square leaves no mean stress, as its inertia forces are its own turned") {
  // Forces along the sides, all counter-clockwise: shear stresses of either sign cancel.
  std::vector<ContactLoad> loads;
  for (int k = 0; k < 4; ++k) {
    const Rotation turn = Rotation::from_angle(0.5 * pi * k);
    loads.push_back({.arm_lab = turn * Vec2{0.01, 0}, .force_lab = turn * Vec2{0, 500}});
  }
  const Stress2 mean = mean_stress(loads, rectangle(0.02, 0.02).ring(), {0, 0}, 4e-4, 0.016);
  const double unit = 500 * 0.01 / (4e-4 * 0.016);
  CHECK(mean.s11 == near(0, 1e-14 * unit));
  CHECK(mean.s22 == near(0, 1e-14 * unit));
  CHECK(mean.s12 == near(0, 1e-14 * unit));
}

TEST_CASE("it is the mean of the element stresses with inertia relief, whatever the loads") {
  Random random(7);
  for (int i = 0; i < 8; ++i) {
    const ConvexPolygon polygon = random_polygon({}, 0.016, random);
    const Mesh mesh = UniformMesher{40}(polygon.ring());
    const InfluenceOperator op(mesh, ConstantStrainTriangle{}, PlaneStress{}, Rock{}, 0.016, false);
    const std::vector<BoundaryLoad> boundary_loads = random_loads(op.mesh(), 4, random);
    std::vector<ContactLoad> loads;
    for (const BoundaryLoad& load : boundary_loads)
      loads.push_back({.arm_lab = op.mesh().position(load.at), .force_lab = load.force_body});
    const Stress2 mean =
        mean_stress(loads, polygon.ring(), {0, 0}, polygon_area(polygon.ring()), 0.016);
    const ElementStress stress = stress_of(op, boundary_loads);
    const Stress2 expected = mean_stress(op.sampling_points(), stress);
    // The solver loses some six digits of the largest stress.
    const double tolerance = 1e-10 * stress.values().cwiseAbs().maxCoeff();
    CHECK(mean.s11 == near(expected.s11, tolerance));
    CHECK(mean.s22 == near(expected.s22, tolerance));
    CHECK(mean.s12 == near(expected.s12, tolerance));
    // Without the moment of the inertia forces it would not be.
    Stress2 without;
    for (const ContactLoad& load : loads)
      without += symmetric_product(load.arm_lab, load.force_lab);
    without = (-1 / (polygon_area(polygon.ring()) * 0.016)) * without;
    CHECK(std::abs(without.s11 - expected.s11) > 1e4 * tolerance);
  }
}
