// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/boundary_load.hpp>

#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <string>

#include <riprap/stress/assemble_and_solve.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/element/linear_strain_triangle.hpp>
#include <riprap/stress/influence_operator.hpp>
#include <riprap/stress/mesher/fan_mesher.hpp>
#include <riprap/stress/mesher/uniform_mesher.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <support/message_of.hpp>
#include <support/polygons.hpp>

using namespace riprap;

TEST_CASE("a load between two nodes, shared by its weights, keeps its force and its moment") {
  const Mesh mesh = UniformMesher{40}(test::regular_polygon(5, 0.01, 0.3).ring());
  for (std::uint32_t node = 0; node < mesh.boundary_nodes; ++node)
    for (const double weight : {0.0, 0.2, 0.77, 1.0}) {
      const BoundaryLoad load{{node, (node + 1) % mesh.boundary_nodes, weight}, {300, -170}, 0};
      const Vec2 first = load.at.weight * load.force_body;
      const Vec2 second = (1 - load.at.weight) * load.force_body;
      const double moment =
          cross(mesh.nodes[load.at.node], first) + cross(mesh.nodes[load.at.next], second);
      // Round-off of products of 0.01 m and 300 N.
      CHECK((first + second - load.force_body).norm() <= 1e-12);
      CHECK(std::abs(moment - cross(mesh.position(load.at), load.force_body)) <= 1e-14);
    }
}

TEST_CASE("a boundary load is none until it is given a force") {
  CHECK(BoundaryLoad{}.force_body == Vec2{0, 0});
  CHECK(BoundaryLoad{}.normal_force == 0);
}

TEST_CASE("a load off the boundary or not finite is refused by every kernel that takes one") {
  const Mesh mesh = FanMesher{2}(test::regular_polygon(5, 0.01).ring());  // node 10 is the centroid
  const ConstantStrainTriangle element;
  const PlaneStress plane;
  const InfluenceOperator op(mesh, element, plane, Rock{}, 0.01, false);
  AssembleAndSolve whole(mesh, element, plane, Rock{}, 0.01,
                         DeterminateSupport::on_opposite_sides(mesh));
  ElementStress stress;
  const auto refuse = [&](const BoundaryLoad& load, const char* rule) {
    CAPTURE(rule);
    const std::array loads{load};
    stress.reset(mesh.size());
    CHECK(test::message_of([&] { op.add_stress(load.at, load.force_body, stress); }) == rule);
    CHECK(test::message_of([&] { whole.solve_free(loads, stress); }) == rule);
    CHECK(test::message_of([&] {
            whole.solve_pinned(loads, {BoundaryPoint{0, 1, 1}, BoundaryPoint{5, 6, 1}}, stress);
          }) == rule);
  };
  const double nan_value = std::nan("");
  refuse({{9999, 0, 0.5}, {1, 0}}, "BoundaryPoint: node = 9999: must be a boundary node");
  refuse({{0, 9999, 0.5}, {1, 0}}, "BoundaryPoint: node = 9999: must be a boundary node");
  refuse({{10, 0, 0.5}, {1, 0}}, "BoundaryPoint: node = 10: must be a boundary node");
  refuse({{0, 1, 1.5}, {1, 0}}, "BoundaryPoint.weight = 1.5: must lie in [0, 1]");
  refuse({{0, 1, nan_value}, {1, 0}}, "BoundaryPoint.weight = nan: must lie in [0, 1]");
  refuse({{0, 1, 0.5}, {nan_value, 0}}, "force of a boundary load (nan, 0) N: must be finite");
  CHECK(test::message_of([&] {
          whole.solve_pinned({}, {BoundaryPoint{0, 1, 1}, BoundaryPoint{10, 6, 1}}, stress);
        }) == "BoundaryPoint: node = 10: must be a boundary node");
}

TEST_CASE("stresses of another size than the sampling points are refused before they are written") {
  const Mesh mesh = FanMesher{2}(test::regular_polygon(5, 0.01).ring());
  const auto refuse = [&](const auto& element, std::size_t size) {
    const InfluenceOperator op(mesh, element, PlaneStress{}, Rock{}, 0.01, false);
    ElementStress stress;
    stress.reset(size);
    CHECK(test::message_of([&] {
            op.add_stress({0, 1, 0.5}, {1, 0}, stress);
          }) == "ElementStress.size() = " + std::to_string(size) +
                    ": must be that of the operator's sampling_points()");
  };
  refuse(ConstantStrainTriangle{}, 0);
  refuse(ConstantStrainTriangle{}, mesh.size() + 1);
  refuse(LinearStrainTriangle{}, mesh.size());  // which has four for each triangle
}
