// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/boundary_locator.hpp>
#include <riprap/stress/mesher/mesh.hpp>

#include <array>
#include <cmath>
#include <doctest/doctest.h>
#include <limits>
#include <utility>

#include <riprap/stress/assemble_and_solve.hpp>
#include <riprap/stress/element/constant_strain_triangle.hpp>
#include <riprap/stress/mesher/fan_mesher.hpp>
#include <riprap/stress/plane_state/plane_stress.hpp>
#include <riprap/stress/prescribed_displacement.hpp>
#include <support/loaded_particle.hpp>
#include <support/message_of.hpp>
#include <support/near.hpp>
#include <support/polygons.hpp>

using namespace riprap;
using test::near;

namespace {

// A rectangle 4 x 2 in four triangles about its middle; the long edges are divided in two.
Mesh small_mesh() {
  Mesh mesh;
  mesh.nodes = {{-2, -1}, {0, -1}, {2, -1}, {2, 1}, {0, 1}, {-2, 1}, {0, 0}};
  mesh.triangles = {{0, 1, 6}, {1, 2, 6}, {2, 3, 6}, {3, 4, 6}, {4, 5, 6}, {5, 0, 6}};
  mesh.corners = {0, 2, 3, 5};
  mesh.boundary_nodes = 6;
  return mesh;
}

// The nearest place on every piece of boundary between two nodes, one by one.
double distance_to_boundary(const Mesh& mesh, const Vec2& x) {
  double nearest = 1e300;
  for (std::uint32_t i = 0; i < mesh.boundary_nodes; ++i) {
    const Vec2 p = mesh.nodes[i];
    const Vec2 edge = mesh.nodes[(i + 1) % mesh.boundary_nodes] - p;
    const double s = std::max(0.0, std::min(1.0, edge.dot(x - p) / edge.squaredNorm()));
    nearest = std::min(nearest, (x - p - s * edge).norm());
  }
  return nearest;
}

}  // namespace

TEST_CASE("triangles of a mesh have the areas and centroids of elementary geometry") {
  const Mesh mesh = small_mesh();
  CHECK(mesh.size() == 6);
  for (std::size_t e = 0; e < 6; ++e) CHECK(mesh.area(e) == (e % 3 == 2 ? 2.0 : 1.0));
  CHECK((mesh.centroid(2) - Vec2{4.0 / 3, 0}).norm() <= 1e-15);
  CHECK((mesh.centroid(0) - Vec2{-2.0 / 3, -2.0 / 3}).norm() <= 1e-15);
  CHECK(mesh.triangle(3)[1] == Vec2{0, 1});
}

TEST_CASE("a point beside an edge goes to its foot on the edge") {
  const Mesh mesh = small_mesh();
  const BoundaryPoint below = nearest_boundary_point(mesh, {0.5, -7});
  CHECK(below.node == 1);
  CHECK(below.next == 2);
  CHECK(below.weight == 0.75);
  // The middle line is nearest to the short edge on its right.
  const BoundaryPoint inside = nearest_boundary_point(mesh, {1.5, 0.25});
  CHECK(inside.node == 2);
  CHECK(inside.next == 3);
  CHECK(inside.weight == 0.375);
  // The last piece of the ring closes it.
  const BoundaryPoint left = nearest_boundary_point(mesh, {-2.1, 0.5});
  CHECK(left.node == 5);
  CHECK(left.next == 0);
  CHECK(left.weight == 0.75);
}

TEST_CASE("a point beyond a corner goes to the corner") {
  const Mesh mesh = small_mesh();
  for (const std::uint32_t corner : mesh.corners) {
    const Vec2 x = 1.7 * mesh.nodes[corner];
    CHECK(mesh.position(nearest_boundary_point(mesh, x)) == mesh.nodes[corner]);
  }
}

TEST_CASE("a place between two boundary nodes finds itself again") {
  Random random(11);
  for (int sample = 0; sample < 30; ++sample) {
    const Mesh mesh = test::random_mesh(random, 60);
    for (const BoundaryLoad& load : test::random_loads(mesh, 20, random)) {
      const Vec2 x = mesh.position(load.at);
      const BoundaryPoint found = nearest_boundary_point(mesh, x);
      // Round-off of coordinates of some centimetres.
      CHECK((mesh.position(found) - x).norm() <= 1e-16);
      CHECK(found.node == load.at.node);
      CHECK(found.next == load.at.next);
      // The same 1e-16 m over pieces of boundary of a millimetre.
      CHECK(found.weight == near(load.at.weight, 1e-13));
    }
  }
}

TEST_CASE("no place on the boundary is nearer than the nearest one, from inside and from outside") {
  Random random(12);
  for (int sample = 0; sample < 30; ++sample) {
    const Mesh mesh = test::random_mesh(random, 60);
    for (int k = 0; k < 50; ++k) {
      const Vec2 x{random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02)};
      const BoundaryPoint found = nearest_boundary_point(mesh, x);
      CHECK(found.node < mesh.boundary_nodes);
      CHECK(found.next == (found.node + 1) % mesh.boundary_nodes);
      CHECK(found.weight >= 0);
      CHECK(found.weight <= 1);
      CHECK(std::abs((mesh.position(found) - x).norm() - distance_to_boundary(mesh, x)) <= 1e-16);
    }
  }
}

TEST_CASE("a mesh that breaks a rule is refused by every kernel that takes one") {
  const Mesh sound = FanMesher{2}(test::regular_polygon(5, 0.01).ring());
  const std::array<std::pair<const char*, void (*)(Mesh&)>, 9> faults{{
      {"Mesh: triangle 3: area [m^2]",
       [](Mesh& m) { std::swap(m.triangles[3][0], m.triangles[3][1]); }},
      {"Mesh: triangle 2: area [m^2] = 0", [](Mesh& m) { m.triangles[2][1] = m.triangles[2][0]; }},
      {"Mesh: triangle 1: node = 9999: must be in the mesh",
       [](Mesh& m) { m.triangles[1][2] = 9999; }},
      {"Mesh: number of triangles = 0", [](Mesh& m) { m.triangles.clear(); }},
      {"Mesh.boundary_nodes = 400", [](Mesh& m) { m.boundary_nodes = 400; }},
      {"Mesh: corner 1 = 400: must be a boundary node", [](Mesh& m) { m.corners[1] = 400; }},
      {"Mesh: corner 2", [](Mesh& m) { m.corners[2] = m.corners[1]; }},
      {"Mesh: node 4 = nan: must be finite", [](Mesh& m) { m.nodes[4].x() = std::nan(""); }},
      {"Mesh: node 11: must be part of a triangle",
       [](Mesh& m) {
         m.nodes.push_back({0, 0});
       }},
  }};
  CHECK_NOTHROW(sound.validate());
  for (const auto& [rule, damage] : faults) {
    CAPTURE(rule);
    Mesh mesh = sound;
    damage(mesh);
    const ConstantStrainTriangle element;
    const PlaneStress plane;
    CHECK(test::contains(test::message_of([&] { mesh.validate(); }), rule));
    CHECK(test::contains(
        test::message_of([&] { InfluenceOperator(mesh, element, plane, Rock{}, 0.01, false); }),
        rule));
    CHECK(test::contains(test::message_of([&] {
                           AssembleAndSolve(mesh, element, plane, Rock{}, 0.01, {0, 1});
                         }),
                         rule));
    CHECK(test::contains(test::message_of([&] {
                           PrescribedDisplacement(mesh, element, plane, Rock{}, 0.01, {{0, 0}});
                         }),
                         rule));
  }
}

TEST_CASE("rock and thickness that break a rule are refused by every kernel that takes them") {
  const Mesh mesh = FanMesher{2}(test::regular_polygon(5, 0.01).ring());
  const ConstantStrainTriangle element;
  const PlaneStress plane;
  const auto refuse = [&](const Rock& rock, double thickness, const char* rule) {
    CAPTURE(rule);
    CHECK(test::contains(
        test::message_of([&] { InfluenceOperator(mesh, element, plane, rock, thickness, false); }),
        rule));
    CHECK(test::contains(test::message_of([&] {
                           AssembleAndSolve(mesh, element, plane, rock, thickness, {0, 1});
                         }),
                         rule));
    CHECK(test::contains(test::message_of([&] {
                           PrescribedDisplacement(mesh, element, plane, rock, thickness, {{0, 0}});
                         }),
                         rule));
  };
  refuse({.young = -1}, 0.01, "Rock.young = -1");
  refuse({.poisson = 0.5}, 0.01, "Rock.poisson = 0.5");
  refuse({.density = std::nan("")}, 0.01, "Rock.density = nan");
  refuse({}, 0, "thickness = 0");
  refuse({}, std::numeric_limits<double>::infinity(), "thickness = inf");
}
