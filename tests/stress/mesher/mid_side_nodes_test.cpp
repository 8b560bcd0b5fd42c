// SPDX-License-Identifier: BSL-1.0
#include <riprap/stress/mesher/mid_side_nodes.hpp>

#include <doctest/doctest.h>

#include <functional>

#include <riprap/stress/boundary_locator.hpp>
#include <support/loaded_particle.hpp>
#include <support/message_of.hpp>

using namespace riprap;

TEST_CASE("two triangles get a node in the middle of each of their five sides") {
  Mesh square;
  square.nodes = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  square.corners = {0, 1, 2, 3};
  square.boundary_nodes = 4;
  const Mesh mesh = with_mid_side_nodes(square);
  const std::vector<Vec2> nodes{{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2},
                                {1, 2}, {0, 2}, {0, 1}, {1, 1}};
  CHECK(mesh.nodes == nodes);
  CHECK(mesh.boundary_nodes == 8);
  CHECK(mesh.corners == std::vector<std::uint32_t>{0, 2, 4, 6});
  CHECK(mesh.triangles == std::vector<std::array<std::uint32_t, 3>>{{0, 2, 4}, {0, 4, 6}});
  CHECK(mesh.mid_sides == std::vector<std::array<std::uint32_t, 3>>{{1, 3, 8}, {8, 5, 7}});
  CHECK(mesh.node(1, 2) == 6);
  CHECK(mesh.node(1, 3) == 8);
}

TEST_CASE("mid-side nodes change neither triangles nor boundary, and there is one for each side") {
  Random random(51);
  for (int sample = 0; sample < 20; ++sample) {
    const Mesh coarse = test::random_mesh(random, random.uniform_integer(10, 150));
    const Mesh mesh = with_mid_side_nodes(coarse);
    CHECK_NOTHROW(mesh.validate());
    REQUIRE(mesh.size() == coarse.size());
    for (std::size_t e = 0; e < mesh.size(); ++e) CHECK(mesh.triangle(e) == coarse.triangle(e));
    // Euler: nodes - sides + triangles = 1 for a disc.
    const std::size_t sides = coarse.nodes.size() + coarse.size() - 1;
    CHECK(mesh.nodes.size() == coarse.nodes.size() + sides);
    // A point of the boundary lies where it lay, in half a side.
    for (int k = 0; k < 50; ++k) {
      const Vec2 x{random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02)};
      const Vec2 there = coarse.position(nearest_boundary_point(coarse, x));
      const BoundaryPoint at = nearest_boundary_point(mesh, x);
      CHECK((mesh.position(at) - there).norm() <= 1e-15);  // round-off of 0.02 m
      CHECK(at.next == (at.node + 1) % mesh.boundary_nodes);
    }
  }
}

TEST_CASE("a piece of boundary that is no side of a triangle is refused") {
  Mesh square;
  square.nodes = {{0, 0}, {2, 0}, {0, 2}, {2, 2}};  // the last two the wrong way round
  square.triangles = {{0, 1, 3}, {0, 3, 2}};
  square.boundary_nodes = 4;
  REQUIRE_NOTHROW(square.validate());
  // Node 3 is to be between nodes 1 and 2, which are on a diagonal.
  const std::string rule = "Mesh: node 3: must be part of a triangle";
  CHECK(test::message_of([&] { (void)with_mid_side_nodes(square); }) == rule);
  CHECK(test::message_of([&] { (void)mesh_for_element<6>(square); }) == rule);
}

TEST_CASE("a mesh gets the nodes of its element, and no others") {
  Random random(52);
  const Mesh coarse = test::random_mesh(random, 30);
  const Mesh mesh = mesh_for_element<6>(coarse);
  CHECK(mesh.mid_sides.size() == coarse.size());
  CHECK(mesh_for_element<6>(mesh).nodes == mesh.nodes);
  CHECK(mesh_for_element<3>(coarse).nodes == coarse.nodes);
  CHECK(test::message_of([&] {
          (void)mesh_for_element<3>(mesh);
        }).find("must be 0 for an element with three nodes") != std::string::npos);
}

TEST_CASE("mid-side nodes that break a rule are named") {
  Random random(53);
  const Mesh mesh = with_mid_side_nodes(test::random_mesh(random, 30));
  struct Fault {
    std::string message;
    std::function<void(Mesh&)> make;
  };
  const std::vector<Fault> faults{
      {"Mesh: triangles with mid-side nodes", [](Mesh& m) { m.mid_sides.pop_back(); }},
      {"must be in the mesh", [](Mesh& m) { m.mid_sides[3][1] = 9999; }},
      {"must be in the middle", [](Mesh& m) { std::swap(m.mid_sides[2][0], m.mid_sides[2][1]); }},
      {"must be in the middle", [](Mesh& m) { m.nodes[1] *= 1.01; }},
      {"must follow its corner",
       [](Mesh& m) {  // the mid-side nodes after all corners
         m.nodes = {{0, 0}, {2, 0}, {0, 2}, {1, 0}, {1, 1}, {0, 1}};
         m.triangles = {{0, 1, 2}};
         m.mid_sides = {{3, 4, 5}};
         m.corners = {0, 1, 2};
         m.boundary_nodes = 6;
       }},
  };
  for (const Fault& fault : faults) {
    Mesh wrong = mesh;
    fault.make(wrong);
    const std::string message = test::message_of([&] { wrong.validate(); });
    CAPTURE(message);
    CHECK(message.find(fault.message) != std::string::npos);
  }
}
