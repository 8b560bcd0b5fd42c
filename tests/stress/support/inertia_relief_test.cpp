// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/support/inertia_relief.hpp>

#include <doctest/doctest.h>

#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <support/loaded_particle.hpp>
#include <support/polygons.hpp>

using namespace riprap;

TEST_CASE("inertia relief leaves every load as it is") {
  Random random(301);
  const Mesh mesh = test::random_mesh(random, 40);
  const InfluenceOperator op(mesh, ConstantStrainTriangle{}, PlaneStress{}, Rock{}, 0.016, false);
  const auto loads = test::random_loads(mesh, 5, random);
  auto balanced = loads;
  InertiaRelief{}.apply_reactions(balanced, op);
  for (std::size_t i = 0; i < loads.size(); ++i)
    CHECK(balanced[i].force_body == loads[i].force_body);
  InertiaRelief{}.apply_reactions({}, op);
  CHECK_FALSE(InertiaRelief::needs_flexibility);
}

// D'Alembert: at x from the pushed end the pressure accelerates the rest of the rod, p (1 - x / L).
TEST_CASE("a rod pushed at one end is pressed less and less towards the free end") {
  const double length = 0.08;
  const double width = 0.02;
  const double pressure = 1e6;
  const double thickness = 0.016;
  const Mesh mesh = UniformMesher{600}(test::rectangle(length, width).ring());
  std::vector<BoundaryLoad> loads;
  // The left end is the last edge.
  for (std::uint32_t i = mesh.corners[3]; i < mesh.boundary_nodes; ++i) {
    const std::uint32_t next = (i + 1) % mesh.boundary_nodes;
    const double force = pressure * thickness * (mesh.nodes[next] - mesh.nodes[i]).norm();
    loads.push_back({{i, next, 0.5}, {force, 0}, force});
  }
  // Without Poisson's ratio the closed form is exact; constant stress in a triangle of spacing h
  // then errs by the change of stress over h, here 2.5 mm.
  const InfluenceOperator op(mesh, ConstantStrainTriangle{}, PlaneStress{}, Rock{70e9, 0, 2500},
                             thickness, false);
  InertiaRelief{}.apply_reactions(loads, op);
  const ElementStress stress = test::stress_of(op, loads);
  const double tolerance = pressure * 0.0025 / length;
  for (std::size_t e = 0; e < mesh.size(); ++e) {
    const double x = mesh.centroid(e).x() + 0.5 * length;
    CHECK(std::abs(stress[e].s11 - pressure * (1 - x / length)) <= tolerance);
    CHECK(std::abs(stress[e].s22) <= tolerance);
    CHECK(std::abs(stress[e].s12) <= tolerance);
  }
}
