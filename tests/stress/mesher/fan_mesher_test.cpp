// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/mesher/fan_mesher.hpp>

#include <doctest/doctest.h>

#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/mean_stress.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <support/loaded_particle.hpp>
#include <support/mesh_checks.hpp>
#include <support/message_of.hpp>
#include <support/polygons.hpp>

using namespace riprap;

namespace {

constexpr double thickness = 0.016;
// Condition of the stiffness, at most 1e5 for so few triangles of any shape, times 1e-16 and some
// tens of operations.
constexpr double round_off = 1e-10;

/// Sharp and blunt ones in turn, with the area of a circle of 16 mm.
ConvexPolygon polygon_of(Random& random, int sample) {
  return random_polygon(sample % 2 ? test::blunt_shape : PolygonShape{}, 0.016, random);
}

InfluenceOperator operator_of(const Mesh& mesh) {
  return {mesh, ConstantStrainTriangle{}, PlaneStress{}, Rock{}, thickness, false};
}

}  // namespace

TEST_CASE("a fan covers any polygon edge to edge, with its area and first moments") {
  Random random(501);
  for (const unsigned divisions : {1u, 2u, 8u, 50u})
    for (int sample = 0; sample < 20; ++sample) {
      const ConvexPolygon polygon = polygon_of(random, sample);
      const Mesh mesh = FanMesher{divisions}(polygon.ring());
      CHECK(mesh.size() == divisions * polygon.size());
      test::check_cover(polygon, mesh);
      test::check_conforming(mesh);
      test::check_even_boundary(polygon, mesh);
      Vec2 first{0, 0};
      for (std::size_t e = 0; e < mesh.size(); ++e) first += mesh.area(e) * mesh.centroid(e);
      // The ring's own centroid lies at the origin to round-off of its size.
      CHECK(first.norm() <= 1e-15 * 0.016 * area_properties(polygon.ring()).area * 10);
    }
}

TEST_CASE("a fan under uniform pressure and shear has that stress in every triangle") {
  Random random(502);
  for (int sample = 0; sample < 10; ++sample) {
    const ConvexPolygon polygon = polygon_of(random, sample);
    const Mesh mesh = FanMesher{random.uniform_integer(1, 12)}(polygon.ring());
    const Stress2 given{3e6, -1e6, 2e6};
    std::vector<BoundaryLoad> loads;
    for (std::uint32_t i = 0; i < mesh.boundary_nodes; ++i) {
      const std::uint32_t next = (i + 1) % mesh.boundary_nodes;
      // Compression is positive: the traction on an outward face is -stress * normal.
      const Vec2 inward = thickness * perpendicular(mesh.nodes[next] - mesh.nodes[i]);
      loads.push_back({{i, next, 0.5},
                       {given.s11 * inward.x() + given.s12 * inward.y(),
                        given.s12 * inward.x() + given.s22 * inward.y()}});
    }
    const ElementStress stress = test::stress_of(operator_of(mesh), loads);
    for (std::size_t e = 0; e < mesh.size(); ++e) {
      CHECK(std::abs(stress[e].s11 - given.s11) <= round_off * 3e6);
      CHECK(std::abs(stress[e].s22 - given.s22) <= round_off * 3e6);
      CHECK(std::abs(stress[e].s12 - given.s12) <= round_off * 3e6);
    }
  }
}

TEST_CASE("the mean stress of a fan in equilibrium is the sum of force times position") {
  Random random(503);
  for (int sample = 0; sample < 20; ++sample) {
    const ConvexPolygon polygon = polygon_of(random, sample);
    const Mesh mesh = FanMesher{}(polygon.ring());
    auto loads = test::random_loads(mesh, 5, random);
    test::balance(loads, mesh);
    Eigen::Matrix2d sum = Eigen::Matrix2d::Zero();
    for (const BoundaryLoad& load : loads)
      sum += load.force_body * mesh.position(load.at).transpose();
    sum /= -thickness * area_properties(polygon.ring()).area;
    const ElementStress stress = test::stress_of(operator_of(mesh), loads);
    const Stress2 mean = mean_stress(SamplingPoints(mesh), stress);
    const double scale = stress.values().cwiseAbs().maxCoeff();
    CHECK(std::abs(mean.s11 - sum(0, 0)) <= round_off * scale);
    CHECK(std::abs(mean.s22 - sum(1, 1)) <= round_off * scale);
    CHECK(std::abs(mean.s12 - 0.5 * (sum(0, 1) + sum(1, 0))) <= round_off * scale);
  }
}

TEST_CASE("a turned particle has the same fan, turned") {
  Random random(504);
  const Rotation turn = Rotation::from_angle(0.7345);
  const ConvexPolygon polygon = polygon_of(random, 0);
  const Mesh mesh = FanMesher{3}(polygon.ring());
  const Mesh turned = FanMesher{3}(polygon.moved(turn, {0, 0}).ring());
  CHECK(turned.triangles == mesh.triangles);
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    CHECK((turned.nodes[i] - turn * mesh.nodes[i]).norm() <= 1e-15 * 0.016);
}

TEST_CASE("a fan has between 1 and 1000 triangles on each edge") {
  CHECK(FanMesher{}.edge_divisions == 8);
  CHECK_NOTHROW(FanMesher{1}.validate());
  CHECK_NOTHROW(FanMesher{1000}.validate());
  CHECK(test::message_of([] { FanMesher{0}.validate(); }) ==
        "FanMesher.edge_divisions = 0: must lie between 1 and 1000");
  CHECK(test::message_of([] { FanMesher{1001}.validate(); }) ==
        "FanMesher.edge_divisions = 1001: must lie between 1 and 1000");
}
