// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/mean_stress.hpp>

#include <doctest/doctest.h>

#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/element/linear_strain_triangle.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <support/loaded_particle.hpp>
#include <support/near.hpp>

using namespace riprap;
using namespace riprap::test;

namespace {

// Two triangles with the areas 3 and 1.
Mesh two_triangles() {
  Mesh mesh;
  mesh.nodes = {{0, 0}, {2, 0}, {2, 3}, {0, 1}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  mesh.boundary_nodes = 4;
  return mesh;
}

}  // namespace

TEST_CASE("each sampling point counts with its area") {
  const Mesh mesh = two_triangles();
  REQUIRE(mesh.area(0) == 3);
  REQUIRE(mesh.area(1) == 1);
  ElementStress stress;
  stress.reset(2);
  stress.set(0, {4, 8, -4});
  stress.set(1, {0, 4, 12});
  const Stress2 mean = mean_stress(SamplingPoints(mesh), stress);
  CHECK(mean.s11 == 3);
  CHECK(mean.s22 == 7);
  CHECK(mean.s12 == 0);
}

TEST_CASE("the mean stress of a balanced particle is that of its boundary forces, on any mesh") {
  const double thickness = 0.016;
  const auto check = [&](const auto& element, unsigned triangles) {
    Random random(4);
    const Mesh mesh = random_mesh(random, triangles);
    const InfluenceOperator op(mesh, element, PlaneStress{}, Rock{}, thickness, false);
    std::vector<BoundaryLoad> loads = random_loads(op.mesh(), 5, random);
    balance(loads, op.mesh());
    double area = 0;
    for (std::size_t e = 0; e < mesh.size(); ++e) area += mesh.area(e);
    Stress2 expected;
    for (const BoundaryLoad& load : loads)
      expected +=
          -1 / (area * thickness) * symmetric_product(op.mesh().position(load.at), load.force_body);
    const ElementStress stress = stress_of(op, loads);
    const Stress2 mean = mean_stress(op.sampling_points(), stress);
    // The solver loses some six digits of the largest stress.
    const double tolerance = 1e-10 * stress.values().cwiseAbs().maxCoeff();
    CHECK(mean.s11 == near(expected.s11, tolerance));
    CHECK(mean.s22 == near(expected.s22, tolerance));
    CHECK(mean.s12 == near(expected.s12, tolerance));
  };
  for (const unsigned triangles : {20u, 60u, 150u}) check(ConstantStrainTriangle{}, triangles);
  check(LinearStrainTriangle{}, 20);
}
